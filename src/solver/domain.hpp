#pragma once

#include <cstddef>

#include "particles/particles.hpp"
#include "terrain/ground.hpp"

namespace sabo {

/// The world around the flow: ground under it, an edge where particles leave.
class Domain {
 public:
  explicit Domain(Ground& ground) : ground_(ground) {}

  /// Takes particles that left the DEM out of `fluid`, puts those found in the ground, a dam or
  /// a body, by more than a tenth of a spacing, back outside (both are counted) and makes the
  /// ground within `reach` (m) of the rest. Called each time the neighbour list is renewed.
  void update(Particles& fluid, Particles& boundary, double reach);

  /// Particles that left since the last call.
  Particles take_departed();
  /// How often a particle was found in a solid since the start.
  std::size_t put_back_count() const { return put_back_count_; }
  const Ground& ground() const { return ground_; }

  /// With the ground.
  template <class Archive>
  void archive(Archive& a) {
    a(ground_, departed_, put_back_count_);
  }

 private:
  void put_back(Particles& fluid, std::size_t i);

  Ground& ground_;
  Particles departed_;
  std::size_t put_back_count_ = 0;
};

}  // namespace sabo
