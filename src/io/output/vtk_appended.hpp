#pragma once

#include <bit>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace sabo {

/// That of this machine, as VTK XML files name it.
inline constexpr const char* vtk_byte_order =
    std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";

/// The appended section of a VTK XML file: arrays one behind the other, each in zlib blocks behind
/// a UInt64 header (number of blocks, block size, size of a last smaller block, compressed sizes).
/// Source: VTK file formats, "XML file formats", compressed appended data.
class VtkAppended {
 public:
  /// Blocks are compressed by so many threads, as host_threads() takes them.
  explicit VtkAppended(int threads = 1) : threads_(threads) {}

  /// Adds an array and returns its DataArray element. `type` is e.g. "Float32".
  std::string add(std::string_view type, std::string_view name, int components,
                  std::span<const std::byte> data);

  const std::string& bytes() const { return bytes_; }

 private:
  int threads_;
  std::string bytes_;
};

}  // namespace sabo
