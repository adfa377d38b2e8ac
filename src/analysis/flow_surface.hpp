#pragma once

#include <vector>

#include "geometry/triangle_mesh.hpp"

#include "analysis/columns.hpp"
#include "terrain/raster.hpp"

namespace sabo {

/// The top of the flow at one moment, as triangles between cell centres.
struct FlowSurface {
  TriangleMesh mesh;           ///< faces look up
  std::vector<double> depth;   ///< of each vertex, m
  std::vector<double> speed;   ///< mean over the column, m/s
  std::vector<double> ground;  ///< elevation below it, m
};

/// Squares of four cell centres are cut as Surface cuts them. A triangle belongs to the surface
/// when one of its corners is wet and all three have ground; its dry corners, with a film or
/// nothing above the ground, are where the flow ends. `elevation` is that of the columns.
FlowSurface flow_surface(const Columns& columns, const Raster& elevation);

}  // namespace sabo
