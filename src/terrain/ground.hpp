#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "particles/boundary_change.hpp"
#include "terrain/body.hpp"
#include "terrain/check_dam.hpp"
#include "terrain/dam_columns.hpp"
#include "terrain/ground_columns.hpp"
#include "terrain/surface.hpp"

namespace sabo {

/// Boundary particles of the terrain, its dams and bodies, made only near the flow: the map is cut
/// into square tiles of 8 x 8 lattice columns. See GroundColumns, dam_columns and body_points for
/// their places. What stands in the ground, in a dam or in an earlier body has none there. Those of
/// dams and bodies carry their number, from 1, dams first. So does the ground under what stands on
/// it, as its foundation: columns whose middle lies under it, each under the first that holds it.
///
/// Why foundations: the flow before a wall reaches past its foot, with the kernel, into the ground
/// under it. In still water of depth H, the same all along, it can be pushed along by nothing but
/// what lies behind the face, which then is pushed by rho g H²/2 in all; half of the corner at the
/// foot is ground. Upwards it is pushed by the ground alone, as a face that is cut off at the foot
/// gets as much from above as from below. So the horizontal part is the wall's.
class Ground {
 public:
  /// Throws CaseError when a dam or body has no part above the ground. The surface must outlive the
  /// ground.
  Ground(const Surface& surface, std::vector<CheckDam> dams, const GroundSettings& settings,
         std::vector<Body> bodies = {});

  /// Makes the tiles within `reach` (m, in plan) of any fluid particle and drops the others: what
  /// is to change in the boundary as the last call left it, in whatever order it is and with
  /// whatever fields the solver has advanced. Threads as host_threads() takes them.
  BoundaryChange follow(std::span<const Vec3d> fluid, double reach, int threads = 1);

  /// Appends every lattice column of the terrain whose centre lies in a rectangle, for periodic
  /// set-ups, without dams and without columns beyond an edge of the domain. follow() knows nothing
  /// of these particles: use one or the other.
  void make_all(double west, double south, double east, double north, Particles& into);

  /// Whether a point of the domain is below the ground, inside a dam or in a body.
  bool is_solid(const Vec3d& point) const;

  /// Nearest point outside the solid, for a particle found inside it.
  Vec3d pushed_out(const Vec3d& point) const;

  const Surface& surface() const { return surface_; }
  double spacing() const { return settings_.spacing; }  ///< m
  const std::vector<CheckDam>& dams() const { return dams_; }
  const std::vector<Body>& bodies() const { return bodies_; }
  std::size_t tile_count() const { return tiles_.size(); }

  /// Which tiles are made; their particles are with those that hold them.
  template <class Archive>
  void archive(Archive& a) {
    a(tiles_, next_id_);
  }

 private:
  std::vector<std::int64_t> tiles_near(std::span<const Vec3d> fluid, double reach,
                                       int threads) const;
  std::vector<IdRun> drop_tiles_except(const std::vector<std::int64_t>& wanted);
  void make_tile(std::int64_t key, std::vector<GroundPoint>& into) const;
  void append(const std::vector<GroundPoint>& points, Particles& into);

  void mark_foundations(double west, double south, std::span<GroundPoint> ground) const;
  bool stands_on(std::size_t structure, double x, double y) const;
  void place_dams();
  void place_body(std::size_t index);
  std::int64_t tile_at(double x, double y) const;

  bool is_in_dam(const Vec3d& point) const;
  bool is_in_body(const Vec3d& point) const;
  Vec3d out_of_ground(const Vec3d& point) const;
  Vec3d out_of_dam(const CheckDam& dam, const Vec3d& point) const;
  Vec3d lifted(Vec3d point) const;

  const Surface& surface_;
  std::vector<CheckDam> dams_;
  std::vector<Body> bodies_;
  std::vector<Bounds> bounds_;  // in plan, dams first
  GroundSettings settings_;
  GroundColumns columns_;
  double tile_size_;
  std::map<std::int64_t, std::vector<DamColumn>> dam_columns_;    // by tile
  std::map<std::int64_t, std::vector<GroundPoint>> body_points_;  // by tile
  std::map<std::int64_t, IdRun> tiles_;                           // their particles
  std::uint32_t next_id_ = 0;
};

}  // namespace sabo
