#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace sabo {

/// Fields as one line with its end, quoted where RFC 4180 asks for it.
std::string csv_line(std::span<const std::string> fields);

/// Where a table goes.
struct TableFile {
  TableFile(std::filesystem::path where, bool is_continued = false)
      : path(std::move(where)), goes_on(is_continued) {}

  std::filesystem::path path;
  bool goes_on;  ///< the file is there, and archive() says how much of it counts
};

/// A table that grows while a run goes on: a header row such as `time [s],front [m]`, then rows of
/// numbers with nine digits. Each row is on disk when append() returns. Errors are RunErrors.
class CsvWriter {
 public:
  /// Replaces an existing file, unless it goes on.
  CsvWriter(const TableFile& file, const std::vector<std::string>& header);

  /// One value per column, finite.
  void append(std::span<const double> row);
  void append(std::initializer_list<double> row) { append({row.begin(), row.size()}); }
  /// The same behind a first column of text.
  void append(const std::string& label, std::span<const double> row);

  /// How far the table has come. What is read takes off what was written later; throws RunError
  /// when the file is not what it was then.
  template <class Archive>
  void archive(Archive& a) {
    if constexpr (!Archive::is_reader) sync();
    a(size_, checksum_);
    if constexpr (Archive::is_reader) take_back();
  }

 private:
  void sync() const;
  void take_back();
  void write_line(const std::string& line);
  /// A row as text, for the columns from `first` on.
  std::string numbers(std::span<const double> row, std::size_t first) const;

  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  std::string name_;
  std::vector<std::string> header_;
  std::uint64_t size_ = 0;      // bytes written
  std::uint32_t checksum_ = 0;  // CRC-32 of them
  std::unique_ptr<std::FILE, Close> file_;
};

}  // namespace sabo
