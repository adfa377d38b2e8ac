#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sabo {

/// A table of numbers with named columns, as CsvWriter writes one.
struct NumberTable {
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns;  ///< all of one length

  /// The column of a name, or nullptr.
  const std::vector<double>* find(std::string_view name) const;
};

/// Fields of the first line of `text`, which is moved behind it; nothing when a quote stays open.
std::optional<std::vector<std::string>> next_csv_line(std::string_view& text);

/// Nothing when the text is no such table: no header, a row of another length, a field that is not
/// a finite number, an open quote. A last line without its end, as a run that is killed leaves it,
/// is left out.
std::optional<NumberTable> parse_number_table(std::string_view text);

/// The table of a file; nothing when there is no such file. Throws CaseError when it holds
/// something else, or more than 1 GB.
std::optional<NumberTable> read_number_table(const std::filesystem::path& file);

}  // namespace sabo
