#pragma once

#include <string>
#include <vector>

#include "geometry/triangle_mesh.hpp"

#include "base/faults.hpp"
#include "case/case.hpp"
#include "run/scene.hpp"

namespace sabo {

/// Makes check dams, deflection walls and buildings: sets dams and buildings of the scene. Adds
/// every fault, also that of an opening which the particles cannot pass.
void read_structures(const Case& c, Scene& scene, Faults& faults);

/// A clear width or height of a dam.
struct ClearWidth {
  std::string key;   ///< e.g. "slit[2].width"
  double width = 0;  ///< m
};

/// All that openings and notch leave free.
std::vector<ClearWidth> clear_widths(const StructureCase& dam);

/// Particles that an opening, and an inflow, should have across; below half of it the flow cannot
/// pass.
inline constexpr double enough_across = 4;

/// What pictures and files show of a dam.
TriangleMesh shown_mesh(const CheckDam& dam, const Scene& scene);

}  // namespace sabo
