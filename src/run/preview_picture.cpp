#include "run/preview_picture.hpp"

#include <algorithm>

#include "analysis/columns.hpp"
#include "run/overlay.hpp"

namespace sabo {
namespace {

/// The part of the map that holds the release and all lines, with a margin, inside the DEM.
MapView view_of(const Grid& grid, const Raster& depth, const std::vector<MapLine>& lines) {
  MapView view = view_around(depth, 0);
  for (const MapLine& line : lines) {
    for (const Vec3d& vertex : line.line.vertices) {
      view.west = std::min(view.west, vertex.x);
      view.east = std::max(view.east, vertex.x);
      view.south = std::min(view.south, vertex.y);
      view.north = std::max(view.north, vertex.y);
    }
  }
  const double margin = 0.03 * std::max(view.east - view.west, view.north - view.south);
  return {std::max(grid.west, view.west - margin), std::max(grid.south(), view.south - margin),
          std::min(grid.east(), view.east + margin), std::min(grid.north, view.north + margin)};
}

}  // namespace

std::string preview_svg(const Case& c, const Scene& scene) {
  const Raster& ground = scene.surface->elevation();
  Columns columns(ground, c.numerics.spacing, c.material.density);
  columns.update(scene.release);
  const Raster depth = columns.depth();

  MapPicture map;
  map.title = c.title.empty() ? "Before the flow" : c.title + ": before the flow";
  map.note = c.note;
  map.quantity = "depth of the release [m]";
  map.lines = overlay(scene);
  for (const MadeEdit& edit : scene.edits)
    add_outlines(MapLine::Kind::edit, edit.report.name, edit.report.name, edit.polygons, map.lines);
  map.view = view_of(ground.grid, depth, map.lines);
  return map_svg(map, ground, depth);
}

}  // namespace sabo
