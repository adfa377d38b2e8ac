#include "io/output/read_hydrograph.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "base/counted.hpp"
#include "base/error.hpp"
#include "base/parsed_number.hpp"
#include "io/output/read_csv.hpp"
#include "io/output/read_file.hpp"

namespace sabo {
namespace {

constexpr std::size_t most_bytes = 100'000'000;
constexpr std::size_t most_rows = 100'000;
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr const char* wanted_columns = "time [s], discharge [m3/s] and, if known, speed [m/s]";

struct Column {
  std::string_view name, unit;
  double most;
};
constexpr std::array<Column, 3> columns{
    {{"time", "[s]", 1e7}, {"discharge", "[m3/s]", 1e6}, {"speed", "[m/s]", 100}}};

std::string trimmed(std::string_view text) {
  const auto is_space = [](char c) { return c == ' ' || c == '\t'; };
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return std::string(text);
}

/// At most so much of it is shown in a message.
std::string shown(const std::string& text) {
  std::string result = text.substr(0, 40);
  for (char& c : result)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  return result;
}

/// Number of the column that a heading names, with its unit or without.
std::optional<std::size_t> column_of(std::string heading) {
  for (char& c : heading) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (std::size_t k = 0; k < columns.size(); ++k)
    if (heading == columns[k].name ||
        heading == fmt::format("{} {}", columns[k].name, columns[k].unit))
      return k;
  return std::nullopt;
}

class Parser {
 public:
  Parser(const std::string& place, const std::string& name) : place_(place), name_(name) {}

  Hydrograph parse(std::string_view text) {
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    while (!text.empty()) {
      ++line_;
      auto fields = next_csv_line(text);
      if (!fields) refuse("has a quote that stays open", "close it");
      for (std::string& field : *fields) field = trimmed(field);
      if (fields->size() == 1 && fields->front().empty()) continue;
      of_field_.empty() ? read_names(*fields) : read_row(*fields);
    }
    Hydrograph result{std::move(values_[0]), std::move(values_[1]), std::move(values_[2])};
    check(result);
    return result;
  }

 private:
  [[noreturn]] void refuse(const std::string& problem, const std::string& remedy) const {
    throw CaseError(place_, fmt::format("{}, line {}: {}", name_, line_, problem), remedy);
  }

  void read_names(const std::vector<std::string>& fields) {
    for (const std::string& field : fields) {
      const auto column = column_of(field);
      if (!column)
        refuse(fmt::format("\"{}\" is not a column of a hydrograph", shown(field)),
               fmt::format("name the columns {}", wanted_columns));
      if (std::ranges::count(of_field_, *column) > 0)
        refuse(fmt::format("has two columns of {}", columns[*column].name), "leave one of them");
      of_field_.push_back(*column);
    }
    for (const std::size_t k : {0u, 1u})
      if (std::ranges::count(of_field_, k) == 0)
        refuse(fmt::format("has no column {}", columns[k].name),
               fmt::format("give the columns {}", wanted_columns));
  }

  void read_row(const std::vector<std::string>& fields) {
    if (fields.size() != of_field_.size())
      refuse(fmt::format("has {} fields instead of {}", fields.size(), of_field_.size()),
             "give one for each column, with a comma between two");
    for (std::size_t k = 0; k < fields.size(); ++k) {
      const Column& column = columns[of_field_[k]];
      const auto value = parsed_number<double>(fields[k]);
      if (!value || !std::isfinite(*value))
        refuse(fmt::format("{} \"{}\" is no number", column.name, shown(fields[k])),
               "give a number with a decimal point");
      if (*value < 0 || *value > column.most)
        refuse(fmt::format("{} {:g} is out of range", column.name, *value),
               fmt::format("give 0 to {:g} {}", column.most,
                           column.unit.substr(1, column.unit.size() - 2)));
      values_[of_field_[k]].push_back(*value);
    }
    const std::vector<double>& time = values_[0];
    if (time.size() > most_rows)
      refuse(fmt::format("there are more than {} rows", most_rows), "give fewer");
    if (time.size() > 1 && !(time.back() > time[time.size() - 2]))
      refuse(fmt::format("time {:g} s is not after {:g} s", time.back(), time[time.size() - 2]),
             "order the rows by time, each time once");
    if (!values_[2].empty() && values_[1].back() > 0 && !(values_[2].back() > 0))
      refuse(fmt::format("a discharge of {:g} m3/s has no speed", values_[1].back()),
             "give a speed above 0 where something flows, or leave the column out");
  }

  void check(const Hydrograph& result) const {
    if (of_field_.empty())
      throw CaseError(place_, name_ + " is empty",
                      fmt::format("give a CSV table with the columns {}", wanted_columns));
    if (result.time.size() < 2)
      throw CaseError(place_, fmt::format("{} has {}", name_, counted(result.time.size(), "row")),
                      "give two at least: discharge is straight between rows");
    if (!(result.volume() > 0))
      throw CaseError(place_, name_ + " has no discharge", "give one above 0");
  }

  const std::string& place_;
  const std::string& name_;
  std::size_t line_ = 0;
  std::vector<std::size_t> of_field_;  // number of its column
  std::array<std::vector<double>, 3> values_;
};

}  // namespace

Hydrograph parse_hydrograph(std::string_view text, const std::string& place,
                            const std::string& name) {
  return Parser(place, name).parse(text);
}

Hydrograph read_hydrograph(const std::filesystem::path& file, const std::string& place) {
  std::error_code error;
  const bool is_empty = std::filesystem::file_size(file, error) == 0 && !error;
  const auto text = is_empty ? std::string() : read_file(file, most_bytes);
  if (!text)
    throw CaseError(place, file.string() + " cannot be read or has more than 100 MB",
                    "give a CSV file");
  return parse_hydrograph(*text, place, file.filename().string());
}

}  // namespace sabo
