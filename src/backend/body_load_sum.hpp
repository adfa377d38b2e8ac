#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "backend/body_load.hpp"
#include "base/error.hpp"
#include "particles/particles.hpp"

namespace sabo {

/// What the fluid does to bodies, from the forces on their particles.
class BodyLoadSum {
 public:
  /// Finds the boundary particles that belong to bodies; no loads yet. Numbers of bodies once known
  /// stay.
  void list(const Particles& boundary) {
    forces_.clear();
    rows_.clear();
    std::size_t bodies = loads_.size();
    for (std::size_t b = 0; b < boundary.size(); ++b) {
      if (boundary.body[b] == 0) continue;
      rows_.push_back(static_cast<std::uint32_t>(b));
      forces_.push_back({boundary.body[b], boundary.position[b], {}});
      bodies = std::max<std::size_t>(bodies, boundary.body[b]);
    }
    loads_.resize(bodies);
  }

  void clear() {
    std::ranges::fill(loads_, BodyLoad{});
    for (BodyForce& at : forces_) at.force = {};
  }

  /// Adds forces on the particles of rows(), N. In their order, whoever summed which.
  void add(const std::vector<Vec3d>& forces) {
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      BodyForce& at = forces_[k];
      at.force += forces[k];
      loads_[at.body - 1] += BodyLoad{forces[k], cross(at.position, forces[k])};
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

  /// Rows of the boundary.
  const std::vector<std::uint32_t>& rows() const { return rows_; }
  const std::vector<BodyLoad>& loads() const { return loads_; }
  const std::vector<BodyForce>& forces() const { return forces_; }

 private:
  std::vector<std::uint32_t> rows_;
  std::vector<BodyForce> forces_;  // by row
  std::vector<BodyLoad> loads_;
};

}  // namespace sabo
