#include "io/output/read_appended.hpp"

#include <cstring>

#include <fmt/format.h>
#include <zlib.h>

#include "base/error.hpp"

namespace sabo {
namespace {

// Deflate's shortest code for its longest copy: 2 bits for 258 bytes. A block that claims more
// cannot be true, and no memory is taken for it.
constexpr std::uint64_t best_ratio = 1032;

}  // namespace

std::uint64_t AppendedReader::take_number(const std::string& name) {
  std::uint64_t value = 0;
  if (bytes_.size() - place_in_bytes_ < sizeof value) {
    throw CaseError(place_, "ends inside \"" + name + "\"", damaged_frame_remedy);
  }
  std::memcpy(&value, bytes_.data() + place_in_bytes_, sizeof value);
  place_in_bytes_ += sizeof value;
  return value;
}

std::vector<std::byte> AppendedReader::read(std::uint64_t offset, std::uint64_t size,
                                            const std::string& name) {
  const auto fail = [&](const std::string& problem) {
    throw CaseError(place_, "\"" + name + "\" " + problem, damaged_frame_remedy);
  };
  if (offset < place_in_bytes_ || offset > bytes_.size()) {
    fail(fmt::format("has an offset of {}, outside its part of the file", offset));
  }
  place_in_bytes_ = offset;
  const std::uint64_t blocks = take_number(name);
  const std::uint64_t block_size = take_number(name);
  const std::uint64_t last_size = take_number(name);
  // Compared by division, which cannot overflow.
  const std::uint64_t last = last_size > 0 ? last_size : block_size;
  const bool is_empty = blocks == 0 && size == 0;
  const bool is_whole = blocks > 0 && block_size > 0 && last <= block_size && last <= size &&
                        (size - last) % block_size == 0 && (size - last) / block_size == blocks - 1;
  if (!is_empty && !is_whole) {
    fail(fmt::format("does not have the {} bytes that the number of particles asks for", size));
  }
  if (blocks > (bytes_.size() - place_in_bytes_) / sizeof(std::uint64_t)) {
    fail(fmt::format("claims {} blocks, more than the file has room for", blocks));
  }
  std::vector<std::uint64_t> packed;
  for (std::uint64_t i = 0; i < blocks; ++i) packed.push_back(take_number(name));

  std::vector<std::byte> content;
  for (std::uint64_t i = 0; i < blocks; ++i) {
    const std::uint64_t whole = i + 1 == blocks ? last : block_size;
    if (packed[i] > bytes_.size() - place_in_bytes_ || whole / best_ratio > packed[i]) {
      fail(fmt::format("has a block of {} bytes that does not fit the file", packed[i]));
    }
    const std::size_t begin = content.size();
    content.resize(begin + whole);
    uLongf unpacked = whole;
    const auto* source = reinterpret_cast<const Bytef*>(bytes_.data() + place_in_bytes_);
    if (uncompress(reinterpret_cast<Bytef*>(content.data() + begin), &unpacked, source,
                   packed[i]) != Z_OK ||
        unpacked != whole) {
      fail(fmt::format("cannot be unpacked: block {} of {} is damaged", i + 1, blocks));
    }
    place_in_bytes_ += packed[i];
  }
  return content;
}

}  // namespace sabo
