#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "backend/backend.hpp"
#include "particles/particle_rows.hpp"
#include "particles/particles.hpp"
#include "physics/equation_of_state.hpp"
#include "solver/inflow.hpp"
#include "terrain/ground.hpp"

namespace sabo {

/// The world around the flow: ground under it, an edge where particles leave, inflows through which
/// they come.
class Domain {
 public:
  /// A particle between four of a wall may come as near to it as this, in spacings beyond the
  /// surface, without any of the five being nearer to another than particles usually are.
  static constexpr double tolerated_depth = 0.1;

  explicit Domain(Ground& ground) : ground_(ground) {}
  /// Inflows number their particles from `next_id` on; the plans, if any, must outlive the domain.
  Domain(Ground& ground, const std::vector<InflowPlan>& inflows, std::uint32_t next_id);

  /// Takes particles that left the DEM out of the fluid, puts those found in the ground, a dam or
  /// a body, by more than a tenth of a spacing, back outside (both are counted) and makes the
  /// ground within the radius of the list of the rest. Called each time the neighbour list is
  /// renewed.
  void update(Backend& backend);

  /// Whether some inflow may bring particles or set some free after a step of `dt` (s): then
  /// neighbours must be renewed before the next step.
  bool layer_is_due(double dt) const {
    return std::ranges::any_of(inflows_, [dt](const Inflow& i) { return i.layer_is_due(dt); });
  }
  /// Rows of the fluid that inflows look at where a layer is due.
  ParticleRows rows_at_inflows(Backend& backend) const;
  /// Lets inflows follow a step of `dt` (s) to `time` (s), see Inflow: by those rows, or, where no
  /// layer is due, by the driven particles.
  void advance_inflows(Particles& fluid, const Tait& state, double time, double dt);

  /// Particles that left since the last call.
  Particles take_departed();
  /// Particles that came through inflows since the last call.
  Particles take_entered();
  /// Those of them that were set free since the last call, as they were then.
  Particles take_freed();
  const std::vector<Inflow>& inflows() const { return inflows_; }
  /// Whether nothing comes any more.
  bool inflows_are_over(double time) const {
    return std::ranges::all_of(inflows_, [time](const Inflow& i) { return i.is_over(time); });
  }
  /// How often a particle was found in a solid since the start.
  std::size_t put_back_count() const { return put_back_count_; }
  const Ground& ground() const { return ground_; }

  /// With the ground.
  template <class Archive>
  void archive(Archive& a) {
    a(ground_, departed_, put_back_count_, next_id_, entered_, freed_);
    a.fixed(inflows_);
  }

 private:
  enum class Place : char { free, outside, solid };
  Place place_of(const Vec3d& x) const;
  void put_back(Backend& backend, const ParticleRows& sunk, const std::vector<Vec3d>& ways_out);

  Ground& ground_;
  std::vector<Inflow> inflows_;
  std::uint32_t next_id_ = 0;
  Particles departed_;
  Particles entered_, freed_;
  std::size_t put_back_count_ = 0;
};

}  // namespace sabo
