#include <cstddef>
#include <cstdint>
#include <string>

#include <zlib.h>

#include "io/output/state_file.hpp"
#include "particles/particles.hpp"

namespace {

/// Some of each kind of member that a checkpoint holds.
struct State {
  sabo::Particles particles;
  std::string text;
  std::vector<std::string> texts;
  std::map<std::int64_t, std::vector<double>> tiles;
  std::deque<std::optional<bool>> choices;

  template <class Archive>
  void archive(Archive& a) {
    a.mark("state");
    a(text, texts, tiles, choices, particles);
  }
};

void read(const std::string& file) {
  try {
    State state;
    sabo::StateFile(file, 1).read([&](sabo::ArchiveReader& a) { a(state); });
    if (state.particles.velocity.size() != state.particles.size()) __builtin_trap();
  } catch (const sabo::RunError&) {
  }
}

}  // namespace

/// Whatever the bytes: a checkpoint is read whole or refused with a RunError, also where the
/// checksum was made to fit, and an archive by itself, too.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  read(bytes);

  std::string sealed("sabo checkpoint\n\1\0\0\0", 20);
  sealed += bytes;
  const auto crc = static_cast<std::uint32_t>(
      crc32_z(0, reinterpret_cast<const Bytef*>(sealed.data()), sealed.size()));
  sealed.append(reinterpret_cast<const char*>(&crc), sizeof crc);
  read(sealed);

  std::size_t place = 0;
  sabo::ArchiveReader reader([&](void* to, std::size_t wanted) {
    const std::size_t count = bytes.copy(static_cast<char*>(to), wanted, place);
    place += count;
    return count;
  });
  try {
    State state;
    reader(state);
    reader.end();
  } catch (const sabo::RunError&) {
  }
  return 0;
}
