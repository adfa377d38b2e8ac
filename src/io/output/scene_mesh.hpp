#pragma once

#include <limits>
#include <vector>

#include "io/output/relief.hpp"
#include "math/vec3.hpp"
#include "terrain/raster.hpp"

namespace sabo {

/// Corner of the surface of a scene.
struct SceneVertex {
  double z = std::numeric_limits<double>::quiet_NaN();  ///< m, of the flow's surface where there is
                                                        ///< flow; NaN without ground
  float elevation = 0;                                  ///< of the ground, m
  float value = 0;                                      ///< of the flow, or of the flow beside it
  float shade = 0;                                      ///< brightness, 0 to 1
  bool is_wet = false;
};

/// Ground and flow as one surface over a rectangular net of corners.
struct SceneMesh {
  std::vector<double> x;              ///< m, from west to east, two or more
  std::vector<double> y;              ///< m, from north to south, two or more
  std::vector<SceneVertex> vertices;  ///< row by row
  double base = 0;                    ///< m, the lowest ground
  double exaggeration = 1;            ///< of heights in the picture

  int columns() const { return static_cast<int>(x.size()); }
  int rows() const { return static_cast<int>(y.size()); }
  const SceneVertex& at(int column, int row) const {
    return vertices[static_cast<std::size_t>(row) * x.size() + column];
  }
  /// Width of a mesh, m.
  double spacing() const;
  /// A height as drawn: exaggerated from the base.
  double drawn(double z) const { return base + exaggeration * (z - base); }
  /// A corner as drawn.
  Vec3d point(int column, int row) const { return {x[column], y[row], drawn(at(column, row).z)}; }
  /// Height of the surface at (x, y), m, not exaggerated; NaN outside and beside holes.
  double height(double east, double north) const;
  bool has_flow() const;
};

/// What a mesh is made of: rasters of one grid, and the depth (m) that counts as flow.
struct SceneData {
  const Raster& elevation;
  const Raster& depth;
  const Raster& values;
  double threshold = 0;
};

/// The cells of the view as a mesh of at most about `max_vertices` corners: beyond that each corner
/// stands for a square of cells, with their mean ground and with the depth and value of the deepest
/// flow among them, so that thin flow is not lost. The ground is lifted by the depth where that is
/// above the threshold. Throws RunError when the rasters' grids differ.
SceneMesh scene_mesh(const SceneData& data, const MapView& view, std::size_t max_vertices,
                     double exaggeration);

/// Sets the brightness of all corners for light from a direction (unit vector towards the light).
void light_mesh(SceneMesh& mesh, const Vec3d& to_light);

}  // namespace sabo
