#include "run/scene_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/mesh_topology.hpp"
#include <fmt/format.h>

#include "base/error.hpp"
#include "io/mesh/read_mesh.hpp"
#include "math/angle.hpp"
#include "run/scene_lines.hpp"
#include "solver/flow_model.hpp"
#include "terrain/body_points.hpp"

namespace sabo {
namespace {

constexpr double same_vertex = 1e-7;      // of the size of a mesh: rounding of single precision
constexpr double largest_number = 1e8;    // of a coordinate, m
constexpr double largest_rounding = 0.1;  // spacings

Vec3d vector_of(const std::array<double, 3>& numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

UprightBox box_of(const BodyCase& c, const Frame& frame) {
  const Vec3d low = in_frame(frame, vector_of(*c.min)), high = in_frame(frame, vector_of(*c.max));
  return {low, high, 0.5 * (low + high), c.rotation * degree};
}

/// Single precision has 24 bits: coordinates of a map lose decimetres in it.
void refuse_if_coarse(const TriangleMesh& mesh, const BodyCase& c, double spacing,
                      const std::string& key) {
  const Bounds bounds = bounds_of(mesh);
  double largest = 0;
  for (const Vec3d& corner : {bounds.low, bounds.high})
    largest = std::max({largest, std::abs(corner.x), std::abs(corner.y), std::abs(corner.z)});
  const double step = largest * c.scale * std::numeric_limits<float>::epsilon();
  const bool is_single = std::all_of(
      mesh.vertices.begin(), mesh.vertices.end(),
      [](const Vec3d& v) { return v.x == float(v.x) && v.y == float(v.y) && v.z == float(v.z); });
  if (!is_single || step < largest_rounding * spacing) return;
  throw CaseError(
      key, fmt::format("is in single precision, whose steps at its coordinates are {:.2g} m", step),
      "write it with coordinates near 0, and give frame = \"local\" and at");
}

TriangleMesh placed(TriangleMesh mesh, const BodyCase& c, const Frame& frame,
                    const std::string& key) {
  const Vec3d shift = in_frame(frame, c.at ? vector_of(*c.at) : Vec3d{});
  for (Vec3d& v : mesh.vertices) {
    v = c.scale * v + shift;
    if (!(std::abs(v.x) < largest_number && std::abs(v.y) < largest_number &&
          std::abs(v.z) < largest_number)) {
      throw CaseError(key, fmt::format("has coordinates beyond {:g} m", largest_number),
                      "check scale and at");
    }
  }
  return mesh;
}

std::string place_text(const Vec3d& point, const Frame& frame) {
  return fmt::format("({:.3f}, {:.3f}, {:.3f})", point.x + frame.origin_x, point.y + frame.origin_y,
                     point.z);
}

TriangleMesh read_closed_mesh(const BodyCase& c, const std::string& key, double spacing,
                              const Frame& frame) {
  const TriangleMesh read = read_mesh(c.file, key);
  refuse_if_coarse(read, c, spacing, key);
  const TriangleMesh whole = placed(read, c, frame, key);
  const double size = norm(bounds_of(whole).size());
  TriangleMesh mesh = size > 0 ? welded(whole, same_vertex * size) : TriangleMesh{};
  const MeshGaps gaps = orient_outwards(mesh);
  if (gaps.open_edges > 0) {
    throw CaseError(
        key,
        fmt::format("{} is not watertight: {} edges are not shared by two triangles, "
                    "one of them at {}",
                    c.file.string(), gaps.open_edges, place_text(gaps.open_edge, frame)),
        "close its holes in a mesh editor");
  }
  if (gaps.is_one_sided) {
    throw CaseError(key, c.file.string() + " has no inside: its surface has one side only",
                    "give the surface of a solid");
  }
  if (mesh.triangles.empty() || !(volume(mesh) > 0)) {
    throw CaseError(key, c.file.string() + " encloses no volume", "give the surface of a solid");
  }
  return mesh;
}

/// Depth to which the flow feels a solid, m.
double reach_of(const Case& c) {
  // Sound speed and density do not matter here.
  return flow_model(c.material, c.numerics, 1).wall_layers() * c.numerics.spacing;
}

Body body_of(const BodyCase& c, const std::string& key, const Case& all, const Frame& frame) {
  const double spacing = all.numerics.spacing;
  const double reach = reach_of(all);
  switch (c.kind) {
    case BodyKind::box: {
      const UprightBox box = box_of(c, frame);
      return {c.name, box_mesh(box), FlowSide::outside, reach, {box}};
    }
    case BodyKind::tank: {
      const UprightBox inside = box_of(c, frame);
      return {c.name, tank_mesh(inside, reach, c.open_top), FlowSide::outside, reach,
              tank_boxes(inside, reach, c.open_top)};
    }
    case BodyKind::mesh:
      break;
  }
  return {c.name, read_closed_mesh(c, key + ".file", spacing, frame),
          c.flow == BodyFlow::inside ? FlowSide::inside : FlowSide::outside, reach};
}

/// Nothing flows where there is no ground.
void refuse_beside(const Body& body, const std::string& key, const Surface& surface) {
  const Grid& grid = surface.elevation().grid;
  const Bounds bounds = body.bounds();
  if (bounds.high.x > grid.west && bounds.low.x < grid.east() && bounds.high.y > grid.south() &&
      bounds.low.y < grid.north)
    return;
  throw CaseError(key, fmt::format("\"{}\" lies beside the DEM", body.name()),
                  "check its coordinates, at and scale, or take a larger DEM");
}

/// Nothing flows in the ground. Corners tell soon; a body may also look out between them.
void refuse_buried(const Body& body, const std::string& key, const Case& c,
                   const Surface& surface) {
  const auto looks_out = [&](const Vec3d& x) {
    return surface.inside(x.x, x.y) && x.z > surface.height(x.x, x.y);
  };
  if (std::ranges::any_of(body.mesh().vertices, looks_out) ||
      std::ranges::any_of(body_points(body, c.numerics.spacing, c.material.density), looks_out,
                          &GroundPoint::position))
    return;
  throw CaseError(key, fmt::format("\"{}\" has no part above the ground", body.name()),
                  "check its place and its elevation");
}

}  // namespace

void read_bodies(const Case& c, Scene& scene, Faults& faults) {
  for (std::size_t k = 0; k < c.bodies.size(); ++k) {
    const std::string key = fmt::format("body[{}]", k + 1);
    collected(faults, [&] {
      scene.bodies.push_back(body_of(c.bodies[k], key, c, scene.frame));
      refuse_beside(scene.bodies.back(), key, *scene.surface);
      refuse_buried(scene.bodies.back(), key, c, *scene.surface);
    });
  }
  const double reach = scene.buildings.empty() ? 0 : reach_of(c);
  for (const Building& building : scene.buildings) {
    collected(faults,
              [&] { scene.bodies.push_back(building_body(building, reach, c.numerics.spacing)); });
  }
}

bool is_shown_solid(const Case& c, std::size_t index) {
  if (index >= c.bodies.size()) return true;
  return c.bodies[index].kind != BodyKind::tank && c.bodies[index].flow == BodyFlow::outside;
}

TriangleMesh shown_mesh(const Case& c, std::size_t index, const Scene& scene) {
  const Body& body = scene.bodies[index];
  return index < c.bodies.size() ? shown_mesh(c.bodies[index], body, scene) : body.mesh();
}

TriangleMesh shown_mesh(const BodyCase& c, const Body& body, const Scene& scene) {
  const bool is_tank = c.kind == BodyKind::tank;
  if (!is_tank && body.flow() == FlowSide::outside) return body.mesh();
  TriangleMesh mesh = body.mesh();
  if (is_tank) {
    const UprightBox inside = box_of(c, scene.frame);
    const double height = inside.low.z - scene.surface->height(inside.pivot.x, inside.pivot.y);
    mesh = box_mesh(inside);
    if (height < 1e-3 * inside.size().z) {
      std::erase_if(mesh.triangles, [&](const Triangle& t) {
        return std::ranges::all_of(
            t, [&](std::uint32_t v) { return mesh.vertices[v].z == inside.low.z; });
      });
    }
  }
  for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  return mesh;
}

}  // namespace sabo
