#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "particles/particles.hpp"

namespace sabo {

/// Where numbered masses are: what it takes to follow their paths. Looks at arrays of another,
/// which have to outlive it.
struct Places {
  std::span<const Vec3d> position;
  std::span<const std::uint32_t> id;
  std::span<const double> mass;

  Places(const Particles& p) : position(p.position), id(p.id), mass(p.mass) {}
  Places(std::span<const Vec3d> positions, std::span<const std::uint32_t> ids,
         std::span<const double> masses)
      : position(positions), id(ids), mass(masses) {}

  std::size_t size() const { return position.size(); }
};

}  // namespace sabo
