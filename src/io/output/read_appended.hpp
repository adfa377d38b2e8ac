#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sabo {

/// Reads the section that VtkAppended wrote.
class AppendedReader {
 public:
  /// `place` is the file's name for the messages. The bytes must outlive the reader.
  AppendedReader(std::string_view bytes, std::string place)
      : bytes_(bytes), place_(std::move(place)) {}

  /// The content of the array at an offset, which must have `size` bytes and stand behind the array
  /// read before. Throws CaseError; allocates no more than the packed bytes can hold.
  std::vector<std::byte> read(std::uint64_t offset, std::uint64_t size, const std::string& name);

 private:
  std::uint64_t take_number(const std::string& name);

  std::string_view bytes_;
  std::string place_;
  std::uint64_t place_in_bytes_ = 0;
};

/// What to do about a file that is not as it was written.
inline constexpr const char* damaged_frame_remedy =
    "run the case again, or leave this file out if it is from another program";

}  // namespace sabo
