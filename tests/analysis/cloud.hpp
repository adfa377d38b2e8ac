#pragma once

#include <vector>

#include "particles/particles.hpp"

namespace sabo {

/// Particles of equal mass (kg) at the given positions, at rest, numbered from 0.
inline Particles cloud(const std::vector<Vec3d>& positions, double mass = 1) {
  Particles particles;
  particles.resize(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    particles.position[i] = positions[i];
    particles.mass[i] = mass;
    particles.id[i] = static_cast<std::uint32_t>(i);
  }
  return particles;
}

}  // namespace sabo
