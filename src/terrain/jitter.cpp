#include "terrain/jitter.hpp"

#include <algorithm>

namespace sabo {
namespace {

/// SplitMix64 (Steele, Lea & Flood 2014): bits of a counter, each result independent of the others.
std::uint64_t mixed_bits(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

/// Even in [-1, 1).
double even_number(std::uint64_t seed, std::uint32_t id, std::uint64_t axis) {
  constexpr std::uint64_t golden = 0x9e3779b97f4a7c15ULL;
  // The seed is mixed on its own: neighbouring seeds must not give each other's numbers shifted.
  const std::uint64_t stream = mixed_bits(golden * (seed + 1));
  const std::uint64_t bits = mixed_bits(stream + golden * (3 * std::uint64_t{id} + axis + 1));
  return static_cast<double>(bits >> 11) * 0x1p-52 - 1;
}

}  // namespace

void jitter(Particles& particles, const Surface& surface, const JitterSettings& settings) {
  if (settings.reach == 0) return;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const auto shift = [&](std::uint64_t axis) {
      return settings.reach * even_number(settings.seed, particles.id[i], axis);
    };
    Vec3d& place = particles.position[i];
    const double height = place.z - surface.height(place.x, place.y);
    const double x = place.x + shift(0), y = place.y + shift(1);
    if (surface.inside(x, y)) {
      place.x = x;
      place.y = y;
    }
    const double lowest = std::min(height, settings.least_height);
    place.z = surface.height(place.x, place.y) + std::max(height + shift(2), lowest);
  }
}

}  // namespace sabo
