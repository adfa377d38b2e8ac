#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace sabo {

/// Fields as one line with its end, quoted where RFC 4180 asks for it.
std::string csv_line(std::span<const std::string> fields);

/// A table that grows while a run goes on: a header row such as `time [s],front [m]`, then rows of
/// numbers with nine digits. Each row is on disk when append() returns. Errors are RunErrors.
class CsvWriter {
 public:
  /// Replaces an existing file.
  CsvWriter(const std::filesystem::path& file, const std::vector<std::string>& header);

  /// One value per column, finite.
  void append(std::span<const double> row);
  void append(std::initializer_list<double> row) { append({row.begin(), row.size()}); }
  /// The same behind a first column of text.
  void append(const std::string& label, std::span<const double> row);

 private:
  void write_line(const std::string& line);
  /// A row as text, for the columns from `first` on.
  std::string numbers(std::span<const double> row, std::size_t first) const;

  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  std::string name_;
  std::vector<std::string> header_;
  std::unique_ptr<std::FILE, Close> file_;
};

}  // namespace sabo
