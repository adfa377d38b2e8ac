#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/faults.hpp"
#include "case/case.hpp"
#include "particles/particles.hpp"
#include "solver/inflow.hpp"
#include "terrain/body.hpp"
#include "terrain/building.hpp"
#include "terrain/check_dam.hpp"
#include "terrain/hole_filling.hpp"
#include "terrain/polyline.hpp"
#include "terrain/raster.hpp"
#include "terrain/surface.hpp"
#include "terrain/terrain_edit.hpp"

namespace sabo {

struct NamedSection {
  std::string name;
  Polyline line;  ///< solver frame
};

struct NamedZone {
  std::string name;
  std::vector<Polygon> polygons;  ///< solver frame
};

struct NamedGauge {
  std::string name;
  Vec3d place;  ///< solver frame; z is where pressure is measured, m
};

/// An edit of the ground that was made.
struct MadeEdit {
  EditReport report;
  std::vector<Polygon> polygons;  ///< solver frame
};

/// Release between a surface before and one after an event.
struct LostGround {
  Raster thickness;  ///< m, on the grid of the DEM; NaN where nothing was lost
  double dug = 0;    ///< m3 by which the ground was lowered to the surface after
};

/// A case made concrete: its files read, checked and moved to the solver frame.
struct Scene {
  Frame frame;
  std::unique_ptr<Surface> surface;
  std::vector<std::string> dem_notes;  ///< what was done to the DEM when it was read
  HoleReport holes;
  std::vector<MadeEdit> edits;
  std::optional<LostGround> lost;    ///< of a release by a pair of DEMs
  std::vector<CheckDam> dams;        ///< check dams first, then deflection walls
  std::size_t deflection_walls = 0;  ///< how many of them
  std::vector<Body> bodies;         ///< numbered after the dams, see Ground; buildings are the last
  std::vector<Building> buildings;  ///< of those bodies
  std::vector<NamedSection> sections;
  std::vector<NamedGauge> gauges;
  std::vector<NamedZone> zones;
  Polyline path;                 ///< along the valley
  bool path_is_descent = false;  ///< not given, but found by steepest descent
  std::vector<InflowPlan> inflows;
  Particles release;            ///< at rest, at the density of a column at rest; may be empty
  double release_volume = 0;    ///< m3
  double release_area = 0;      ///< in plan, m2
  double release_left_out = 0;  ///< m3 that would stand inside structures and bodies
  double release_depth = 0;     ///< greatest, m
  Vec3d release_centre;         ///< without a release, where the largest inflow comes in

  /// Those that hold back the flow, so that it is asked what they trap.
  std::span<const CheckDam> check_dams() const {
    return std::span(dams).first(dams.size() - deflection_walls);
  }
  /// Whether a place is in a dam or body.
  bool is_solid(const Vec3d& place) const;
  /// On which side of a dam the release is: 1 to the left of its axis, -1 to the right.
  int side_of_release(const CheckDam& dam) const;
  /// Greatest depth of the release and of the inflows at their line, m.
  double greatest_depth() const;
  /// Particles of the release, and of the inflows until a time (s).
  std::size_t particles_until(double time) const;
};

/// Reads everything a case names. Faults are added, all that can be found at once; the scene is of
/// use only when there are none.
Scene make_scene(const Case& c, Faults& faults);

/// Runs one part of the reading; its CaseError joins the other faults, and the result is false.
bool collected(Faults& faults, const std::function<void()>& part);

}  // namespace sabo
