#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sabo {

/// Columns of numbers under their names, e.g. `time [s]`. All columns are equally long; a field
/// that is no number is NaN.
struct SeriesTable {
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns;

  std::size_t rows() const { return columns.empty() ? 0 : columns.front().size(); }
  /// The column of a name, or nullptr.
  const std::vector<double>* find(std::string_view name) const;
};

/// Fields of one line, with the quotes of RFC 4180 taken off.
std::vector<std::string> csv_fields(std::string_view line);

/// Reads a table as CsvWriter writes it. A last line without its end or with another number of
/// fields, as a run that is killed may leave it, is left out. Throws CaseError if the file cannot
/// be read, is larger than 1 GB or has no header.
SeriesTable read_series(const std::filesystem::path& file);

}  // namespace sabo
