#include "io/output/checksum.hpp"

#include <fstream>
#include <vector>

#include <fmt/format.h>
#include <zlib.h>

#include "base/error.hpp"

namespace sabo {

std::string checksum(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::vector<char> block(1 << 20);
  uLong sum = crc32(0, nullptr, 0);
  while (in.read(block.data(), static_cast<std::streamsize>(block.size())) || in.gcount() > 0) {
    sum = crc32(sum, reinterpret_cast<const Bytef*>(block.data()), static_cast<uInt>(in.gcount()));
  }
  if (!in.eof()) throw RunError("cannot read " + file.string());
  return fmt::format("{:08x}", sum);
}

}  // namespace sabo
