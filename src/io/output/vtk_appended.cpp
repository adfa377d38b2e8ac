#include "io/output/vtk_appended.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

#include <fmt/format.h>
#include <zlib.h>

#include "base/error.hpp"
#include "base/host_loops.hpp"
#include "io/output/markup.hpp"

namespace sabo {
namespace {

constexpr std::size_t block_size = 1 << 18;  // bytes before compression
constexpr int zlib_level = 1;                // of zlib; particle data gain little from higher ones

std::string compressed(std::span<const std::byte> block) {
  uLongf size = compressBound(block.size());
  std::string packed(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                reinterpret_cast<const Bytef*>(block.data()), block.size(), zlib_level) != Z_OK) {
    throw RunError("not enough memory to compress a frame");
  }
  packed.resize(size);
  return packed;
}

}  // namespace

std::string VtkAppended::add(std::string_view type, std::string_view name, int components,
                             std::span<const std::byte> data) {
  const std::size_t offset = bytes_.size();
  const std::size_t count = (data.size() + block_size - 1) / block_size;
  std::vector<std::uint64_t> header{count, block_size, data.size() % block_size};
  header.resize(3 + count);
  bytes_.append(header.size() * sizeof(std::uint64_t), '\0');

  std::vector<std::string> packed(count);
  over_few(count, host_threads(threads_), [&](std::size_t i) {
    packed[i] = compressed(
        data.subspan(i * block_size, std::min(block_size, data.size() - i * block_size)));
  });
  for (std::size_t i = 0; i < count; ++i) {
    header[3 + i] = packed[i].size();
    bytes_ += packed[i];
  }
  bytes_.replace(offset, header.size() * sizeof(std::uint64_t),
                 reinterpret_cast<const char*>(header.data()),
                 header.size() * sizeof(std::uint64_t));
  return fmt::format(
      "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" "
      "offset=\"{}\"/>\n",
      type, escaped(name), components, offset);
}

}  // namespace sabo
