#pragma once

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "backend/body_load.hpp"
#include "base/error.hpp"

namespace sabo {

/// What the fluid does to bodies, from the forces on their particles.
class BodyLoadSum {
 public:
  /// Takes the boundary particles that belong to bodies, in the order in which their forces come,
  /// and the level of the ground, if there is one, to which foundations are raised. Loads stay what
  /// they were: those of bodies once known, whether or not they have particles.
  void list(std::vector<BodyForce> particles, const GroundLevel& ground) {
    forces_ = std::move(particles);
    std::size_t bodies = loads_.size();
    for (BodyForce& at : forces_) {
      bodies = std::max<std::size_t>(bodies, at.body);
      if (at.is_foundation && ground) at.position.z = ground(at.position.x, at.position.y);
    }
    loads_.resize(bodies);
  }

  /// Takes the forces on the listed particles, N, in the order of the list, and sums them up by
  /// body in that order.
  void sum(std::span<const Vec3d> forces) {
    std::ranges::fill(loads_, BodyLoad{});
    for (std::size_t k = 0; k < forces_.size(); ++k) {
      BodyForce& at = forces_[k];
      at.force = forces[k];
      if (at.is_foundation) at.force.z = 0;
      loads_[at.body - 1] += BodyLoad{at.force, cross(at.position, at.force)};
    }
  }

  /// Takes the loads of another one. Throws RunError unless its bodies are the same.
  void restore(const BodyLoadSum& other) {
    if (!std::ranges::equal(forces_, other.forces_, {}, &BodyForce::body, &BodyForce::body) ||
        loads_.size() != other.loads_.size())
      throw RunError("holds forces on other bodies");
    loads_ = other.loads_;
    forces_ = other.forces_;
  }

  template <class Archive>
  void archive(Archive& a) {
    a(loads_, forces_);
  }

  const std::vector<BodyLoad>& loads() const { return loads_; }
  const std::vector<BodyForce>& forces() const { return forces_; }

 private:
  std::vector<BodyForce> forces_;
  std::vector<BodyLoad> loads_;
};

}  // namespace sabo
