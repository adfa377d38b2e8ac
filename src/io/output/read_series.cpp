#include "io/output/read_series.hpp"

#include <algorithm>
#include <charconv>
#include <limits>

#include "base/error.hpp"
#include "io/output/read_file.hpp"

namespace sabo {
namespace {

constexpr std::size_t max_bytes = 1'000'000'000;

double number_of(const std::string& field) {
  double value = 0;
  const char* end = field.data() + field.size();
  const auto read = std::from_chars(field.data(), end, value);
  const bool is_number = read.ec == std::errc() && read.ptr == end;
  return is_number ? value : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

const std::vector<double>* SeriesTable::find(std::string_view name) const {
  const auto found = std::ranges::find(names, name);
  return found == names.end() ? nullptr : &columns[static_cast<std::size_t>(found - names.begin())];
}

std::vector<std::string> csv_fields(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  std::vector<std::string> fields(1);
  bool is_quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    const bool is_escaped_quote =
        is_quoted && c == '"' && i + 1 < line.size() && line[i + 1] == '"';
    if (is_escaped_quote) {
      fields.back() += line[++i];
    } else if (c == '"') {
      is_quoted = !is_quoted;
    } else if (c == ',' && !is_quoted) {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  return fields;
}

SeriesTable read_series(const std::filesystem::path& file) {
  const auto content = read_file(file, max_bytes);
  if (!content) throw CaseError(file.string(), "cannot be read as a table", "run the case again");
  std::string_view rest = *content;
  SeriesTable table;
  for (std::size_t end = rest.find('\n'); end != rest.npos; end = rest.find('\n')) {
    const std::vector<std::string> fields = csv_fields(rest.substr(0, end));
    rest.remove_prefix(end + 1);
    if (table.names.empty()) {
      table.names = fields;
      table.columns.resize(fields.size());
    } else if (fields.size() == table.names.size()) {
      for (std::size_t k = 0; k < fields.size(); ++k)
        table.columns[k].push_back(number_of(fields[k]));
    }
  }
  if (table.names.empty()) throw CaseError(file.string(), "has no header", "run the case again");
  return table;
}

}  // namespace sabo
