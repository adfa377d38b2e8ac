#include <cstddef>
#include <cstdint>
#include <string_view>

#include "base/error.hpp"
#include "io/output/read_vtp.hpp"

/// Whatever the bytes: the readers of frames and of their list return or throw CaseError, and what
/// they return is whole.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  try {
    const sabo::ParticleFrame frame = sabo::parse_particles_vtp(bytes, "frame");
    for (const sabo::ParticleArray& array : frame.arrays) {
      if (array.values.size() != frame.points.size() * array.components) __builtin_trap();
    }
  } catch (const sabo::CaseError&) {
  }
  try {
    for (const sabo::PvdEntry& entry : sabo::parse_pvd(bytes, "list")) {
      if (entry.file.empty() || entry.file.front() == '/') __builtin_trap();
    }
  } catch (const sabo::CaseError&) {
  }
  return 0;
}
