#pragma once

#include <cstdint>

#include "particles/particles.hpp"
#include "terrain/surface.hpp"

namespace sabo {

struct JitterSettings {
  double reach = 0;         ///< greatest displacement along each axis, m
  double least_height = 0;  ///< above the ground, m; what was lower keeps its height
  std::uint64_t seed = 0;
};

/// Displaces each particle by three random numbers, even in [-reach, reach), that depend on the
/// seed and its number alone: the same on every machine and in any order of the rows. It moves
/// along the ground, keeping its height above it but for the vertical displacement, so that none
/// comes below; one that would leave the surface keeps its place in plan. Masses stay.
void jitter(Particles& particles, const Surface& surface, const JitterSettings& settings);

}  // namespace sabo
