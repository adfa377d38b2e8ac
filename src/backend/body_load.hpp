#pragma once

#include <cstdint>
#include <functional>

#include "math/vec3.hpp"

namespace sabo {

/// What the fluid does to a body; in two dimensions per metre across.
struct BodyLoad {
  Vec3d force;   ///< N
  Vec3d moment;  ///< about the origin, N m

  /// The moment about another point.
  Vec3d moment_about(const Vec3d& point) const { return moment - cross(point, force); }

  BodyLoad& operator+=(const BodyLoad& other) {
    force += other.force;
    moment += other.moment;
    return *this;
  }
  friend BodyLoad operator*(double factor, const BodyLoad& load) {
    return {factor * load.force, factor * load.moment};
  }
};

/// Elevation of the ground at a place in plan, m.
using GroundLevel = std::function<double(double x, double y)>;

/// A part of it that acts at one boundary particle.
struct BodyForce {
  std::uint32_t body = 0;      ///< its number, from 1
  bool is_foundation = false;  ///< at the ground under the body, which bears the weight itself
  Vec3d position;              ///< of the particle; of a foundation the ground above it, m
  Vec3d force;                 ///< N; of a foundation the horizontal part alone

  template <class Archive>
  void archive(Archive& a) {
    a(body, is_foundation, position, force);
  }
};

}  // namespace sabo
