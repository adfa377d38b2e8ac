#include "io/output/scene_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "base/error.hpp"

namespace sabo {
namespace {

// Cells along one axis that become one corner: [first, last], and its coordinate.
struct Block {
  int first = 0;
  int last = 0;
  double place = 0;
};

// The cells whose centres lie in [low, high] in blocks of `stride`. Cells are numbered from
// `origin` in steps of `step` (negative from north to south). One cell alone becomes two corners,
// its edges, so that every mesh has an area.
std::vector<Block> blocks_of(int first, int last, int stride, double origin, double step) {
  std::vector<Block> blocks;
  for (int cell = first; cell <= last; cell += stride) {
    const int end = std::min(cell + stride - 1, last);
    blocks.push_back({cell, end, origin + (0.5 * (cell + end) + 0.5) * step});
  }
  if (blocks.size() == 1) {
    blocks.push_back(blocks.front());
    blocks[0].place = origin + first * step;
    blocks[1].place = origin + (last + 1) * step;
  }
  return blocks;
}

struct CellRange {
  int first = 0;
  int last = 0;
  std::size_t size() const { return static_cast<std::size_t>(last) - first + 1; }
};

// At least one cell, the nearest one for a view outside the grid.
CellRange cells_between(double low, double high, int count) {
  const auto cell = [count](double place) {
    return static_cast<int>(std::clamp(place, 0.0, count - 1.0));
  };
  const int first = cell(std::ceil(low - 0.5));
  return {first, std::max(first, cell(std::floor(high - 0.5)))};
}

SceneVertex vertex_of(const SceneData& data, const Block& columns, const Block& rows) {
  SceneVertex vertex;
  double sum = 0, deepest = 0;
  int count = 0;
  for (int row = rows.first; row <= rows.last; ++row) {
    for (int column = columns.first; column <= columns.last; ++column) {
      const std::size_t i = data.elevation.grid.index(column, row);
      const double z = data.elevation.values[i];
      if (!std::isfinite(z)) continue;
      sum += z;
      ++count;
      const double depth = data.depth.values[i];
      if (!(depth > data.threshold && depth > deepest) || !std::isfinite(depth)) continue;
      deepest = depth;
      const double value = data.values.values[i];
      vertex.value = std::isfinite(value) ? static_cast<float>(value) : 0;
      vertex.is_wet = true;
    }
  }
  if (count == 0) return vertex;
  vertex.elevation = static_cast<float>(sum / count);
  vertex.z = sum / count + deepest;
  return vertex;
}

template <class Visit>
void for_each_neighbour(const SceneMesh& mesh, int column, int row, Visit&& visit) {
  for (int r = std::max(row - 1, 0); r <= std::min(row + 1, mesh.rows() - 1); ++r) {
    for (int c = std::max(column - 1, 0); c <= std::min(column + 1, mesh.columns() - 1); ++c) {
      visit(mesh.at(c, r));
    }
  }
}

// Dry corners beside flow take its value, so that its colour does not fade towards its edge.
void spread_values(SceneMesh& mesh) {
  for (int row = 0; row < mesh.rows(); ++row) {
    for (int column = 0; column < mesh.columns(); ++column) {
      SceneVertex& vertex = mesh.vertices[static_cast<std::size_t>(row) * mesh.x.size() + column];
      if (vertex.is_wet) continue;
      float sum = 0;
      int count = 0;
      for_each_neighbour(mesh, column, row, [&](const SceneVertex& other) {
        if (!other.is_wet) return;
        sum += other.value;
        ++count;
      });
      if (count > 0) vertex.value = sum / static_cast<float>(count);
    }
  }
}

}  // namespace

double SceneMesh::spacing() const {
  const double wide = (x.back() - x.front()) / (columns() - 1);
  const double high = (y.front() - y.back()) / (rows() - 1);
  return std::max(wide, high);
}

bool SceneMesh::has_flow() const {
  return std::ranges::any_of(vertices, [](const SceneVertex& v) { return v.is_wet; });
}

double SceneMesh::height(double east, double north) const {
  if (!(east >= x.front() && east <= x.back() && north <= y.front() && north >= y.back())) {
    return Raster::no_data;
  }
  const auto right = std::upper_bound(x.begin() + 1, x.end() - 1, east);
  const auto below = std::upper_bound(y.begin() + 1, y.end() - 1, north, std::greater<>());
  const int column = static_cast<int>(right - x.begin()) - 1;
  const int row = static_cast<int>(below - y.begin()) - 1;
  const double s = (east - x[column]) / (x[column + 1] - x[column]);
  const double t = (y[row] - north) / (y[row] - y[row + 1]);
  return (1 - t) * ((1 - s) * at(column, row).z + s * at(column + 1, row).z) +
         t * ((1 - s) * at(column, row + 1).z + s * at(column + 1, row + 1).z);
}

SceneMesh scene_mesh(const SceneData& data, const MapView& view, std::size_t max_vertices,
                     double exaggeration) {
  const Grid& grid = data.elevation.grid;
  if (data.depth.grid != grid || data.values.grid != grid || grid.size() == 0) {
    throw RunError("cannot draw a scene: its rasters have different grids");
  }
  const CellRange columns = cells_between((view.west - grid.west) / grid.dx,
                                          (view.east - grid.west) / grid.dx, grid.columns);
  const CellRange rows = cells_between((grid.north - view.north) / grid.dy,
                                       (grid.north - view.south) / grid.dy, grid.rows);
  const double share = static_cast<double>(columns.size()) * static_cast<double>(rows.size()) /
                       static_cast<double>(max_vertices);
  const int stride = std::max(1, static_cast<int>(std::ceil(std::sqrt(share))));
  const auto across = blocks_of(columns.first, columns.last, stride, grid.west, grid.dx);
  const auto down = blocks_of(rows.first, rows.last, stride, grid.north, -grid.dy);

  SceneMesh mesh;
  mesh.exaggeration = exaggeration;
  for (const Block& block : across) mesh.x.push_back(block.place);
  for (const Block& block : down) mesh.y.push_back(block.place);
  mesh.vertices.reserve(across.size() * down.size());
  double lowest = std::numeric_limits<double>::infinity();
  for (const Block& row : down) {
    for (const Block& column : across) {
      mesh.vertices.push_back(vertex_of(data, column, row));
      const SceneVertex& vertex = mesh.vertices.back();
      if (!std::isnan(vertex.z)) lowest = std::min<double>(lowest, vertex.elevation);
    }
  }
  if (std::isfinite(lowest)) mesh.base = lowest;
  spread_values(mesh);
  return mesh;
}

void light_mesh(SceneMesh& mesh, const Vec3d& to_light) {
  // Beside flow the ground keeps its own slope; the slope up to the flow's surface is flow.
  const auto z_at = [&mesh](int column, int row, const SceneVertex& seen_from) {
    const SceneVertex& vertex = mesh.at(column, row);
    if (std::isnan(vertex.z)) return mesh.drawn(seen_from.z);
    return mesh.drawn(seen_from.is_wet ? vertex.z : vertex.elevation);
  };
  for (int row = 0; row < mesh.rows(); ++row) {
    const int north = std::max(row - 1, 0), south = std::min(row + 1, mesh.rows() - 1);
    for (int column = 0; column < mesh.columns(); ++column) {
      SceneVertex& vertex = mesh.vertices[static_cast<std::size_t>(row) * mesh.x.size() + column];
      if (std::isnan(vertex.z)) continue;
      const int west = std::max(column - 1, 0), east = std::min(column + 1, mesh.columns() - 1);
      const double to_east =
          (z_at(east, row, vertex) - z_at(west, row, vertex)) / (mesh.x[east] - mesh.x[west]);
      const double to_north = (z_at(column, north, vertex) - z_at(column, south, vertex)) /
                              (mesh.y[north] - mesh.y[south]);
      const Vec3d normal = normalised(Vec3d{-to_east, -to_north, 1});
      vertex.shade = static_cast<float>(0.5 + 0.5 * dot(normal, to_light));
    }
  }
}

}  // namespace sabo
