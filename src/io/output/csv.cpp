#include "io/output/csv.hpp"

#include <cerrno>
#include <cmath>
#include <system_error>

#include <fmt/format.h>

#include "base/error.hpp"

namespace sabo {
namespace {

// Quoted where RFC 4180 asks for it.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted;
  for (char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return fmt::format("\"{}\"", quoted);
}

}  // namespace

std::string csv_line(std::span<const std::string> fields) {
  std::string line;
  for (std::size_t k = 0; k < fields.size(); ++k) {
    if (k > 0) line += ',';
    line += field(fields[k]);
  }
  return line + '\n';
}

CsvWriter::CsvWriter(const std::filesystem::path& file, const std::vector<std::string>& header)
    : name_(file.string()), header_(header), file_(std::fopen(file.c_str(), "wb")) {
  if (!file_) {
    throw RunError(
        fmt::format("cannot write {}: {}", name_, std::generic_category().message(errno)));
  }
  write_line(csv_line(header_));
}

void CsvWriter::append(std::span<const double> row) { write_line(numbers(row, 0)); }

void CsvWriter::append(const std::string& label, std::span<const double> row) {
  write_line(field(label) + ',' + numbers(row, 1));
}

std::string CsvWriter::numbers(std::span<const double> row, std::size_t first) const {
  if (first + row.size() != header_.size()) {
    throw RunError(
        fmt::format("{}: {} values for {} columns", name_, first + row.size(), header_.size()));
  }
  std::string line;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (!std::isfinite(row[i])) {
      throw RunError(fmt::format("{}: {} is {}", name_, header_[first + i], row[i]));
    }
    line += fmt::format("{}{:.9g}", i == 0 ? "" : ",", row[i]);
  }
  return line + '\n';
}

void CsvWriter::write_line(const std::string& line) {
  errno = 0;
  const bool is_written = std::fputs(line.c_str(), file_.get()) >= 0;
  if (std::fflush(file_.get()) != 0 || !is_written) {
    throw RunError(
        fmt::format("cannot write {}: {}", name_, std::generic_category().message(errno)));
  }
}

}  // namespace sabo
