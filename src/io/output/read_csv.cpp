#include "io/output/read_csv.hpp"

#include <algorithm>
#include <system_error>

#include "base/error.hpp"
#include "base/parsed_number.hpp"
#include "io/output/read_file.hpp"

namespace sabo {
namespace {

constexpr std::size_t max_bytes = 1'000'000'000;

}  // namespace

std::optional<std::vector<std::string>> next_csv_line(std::string_view& text) {
  std::vector<std::string> fields(1);
  bool is_quoted = false;
  std::size_t at = 0;
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (is_quoted && c == '"' && at + 1 < text.size() && text[at + 1] == '"') {
      fields.back() += '"';
      ++at;
    } else if (c == '"') {
      is_quoted = !is_quoted;
    } else if (is_quoted) {
      fields.back() += c;
    } else if (c == ',') {
      fields.emplace_back();
    } else if (c == '\n') {
      break;
    } else if (c != '\r') {
      fields.back() += c;
    }
  }
  text.remove_prefix(std::min(at + 1, text.size()));
  if (is_quoted) return std::nullopt;
  return fields;
}

const std::vector<double>* NumberTable::find(std::string_view name) const {
  const auto found = std::ranges::find(names, name);
  return found == names.end() ? nullptr : &columns[found - names.begin()];
}

std::optional<NumberTable> parse_number_table(std::string_view text) {
  text = text.substr(0, text.rfind('\n') + 1);  // all of it but a line without its end
  auto header = next_csv_line(text);
  if (!header || (header->size() == 1 && header->front().empty())) return std::nullopt;
  NumberTable table{std::move(*header), {}};
  table.columns.resize(table.names.size());
  while (!text.empty()) {
    const auto fields = next_csv_line(text);
    if (!fields || fields->size() != table.names.size()) return std::nullopt;
    for (std::size_t k = 0; k < fields->size(); ++k) {
      const auto value = finite_number<double>((*fields)[k]);
      if (!value) return std::nullopt;
      table.columns[k].push_back(*value);
    }
  }
  return table;
}

std::optional<NumberTable> read_number_table(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return std::nullopt;
  const auto text = read_file(file, max_bytes);
  auto table = text ? parse_number_table(*text) : std::nullopt;
  if (!table)
    throw CaseError(file.string(), "is not a table of numbers as a run writes them",
                    "run the case again");
  return table;
}

}  // namespace sabo
