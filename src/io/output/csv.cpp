#include "io/output/csv.hpp"

#include <array>
#include <cerrno>
#include <cmath>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>
#include <zlib.h>

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

CsvWriter::CsvWriter(const TableFile& file, const std::vector<std::string>& header)
    : name_(file.path.string()),
      header_(header),
      file_(std::fopen(file.path.c_str(), file.goes_on ? "r+b" : "wb")) {
  if (!file_) {
    throw RunError(
        fmt::format("cannot write {}: {}", name_, std::generic_category().message(errno)));
  }
  if (!file.goes_on) write_line(csv_line(header_));
}

void CsvWriter::sync() const {
  if (fsync(fileno(file_.get())) != 0)
    throw RunError(
        fmt::format("cannot write {}: {}", name_, std::generic_category().message(errno)));
}

void CsvWriter::take_back() {
  std::array<unsigned char, 1 << 16> block{};
  std::uint64_t left = size_;
  uLong sum = crc32(0, nullptr, 0);
  std::rewind(file_.get());
  while (left > 0) {
    const std::size_t wanted = std::min<std::uint64_t>(left, block.size());
    const std::size_t taken = std::fread(block.data(), 1, wanted, file_.get());
    if (taken == 0) break;
    sum = crc32(sum, block.data(), static_cast<uInt>(taken));
    left -= taken;
  }
  if (left > 0 || sum != checksum_) throw RunError(name_ + " is no longer as it was then");
  if (ftruncate(fileno(file_.get()), static_cast<off_t>(size_)) != 0 ||
      std::fseek(file_.get(), 0, SEEK_END) != 0)
    throw RunError(
        fmt::format("cannot write {}: {}", name_, std::generic_category().message(errno)));
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
  size_ += line.size();
  checksum_ = static_cast<std::uint32_t>(crc32(
      checksum_, reinterpret_cast<const Bytef*>(line.data()), static_cast<uInt>(line.size())));
}

}  // namespace sabo
