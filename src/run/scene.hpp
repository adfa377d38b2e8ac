#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/faults.hpp"
#include "case/case.hpp"
#include "particles/particles.hpp"
#include "terrain/check_dam.hpp"
#include "terrain/hole_filling.hpp"
#include "terrain/polyline.hpp"
#include "terrain/raster.hpp"
#include "terrain/surface.hpp"

namespace sabo {

struct NamedSection {
  std::string name;
  Polyline line;  ///< solver frame
};

/// A case made concrete: its files read, checked and moved to the solver frame.
struct Scene {
  Frame frame;
  std::unique_ptr<Surface> surface;
  HoleReport holes;
  std::vector<CheckDam> dams;
  std::vector<NamedSection> sections;
  Polyline path;                 ///< along the valley
  bool path_is_descent = false;  ///< not given, but found by steepest descent
  Particles release;             ///< at rest, at the density of a column at rest
  double release_volume = 0;     ///< m3
  double release_depth = 0;      ///< greatest, m
  Vec3d release_centre;
};

/// Reads everything a case names. Faults are added, all that can be found at once; the scene is of
/// use only when there are none.
Scene make_scene(const Case& c, Faults& faults);

}  // namespace sabo
