#include "run/scene_release.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/gis/read_points.hpp"
#include "io/gis/read_raster.hpp"
#include "io/gis/read_vectors.hpp"
#include "run/scene_lines.hpp"
#include "solver/flow_model.hpp"
#include "terrain/jitter.hpp"
#include "terrain/polygon_checks.hpp"
#include "terrain/release.hpp"

namespace sabo {
namespace {

/// Where two overlap, thickness and volume would each count another of them.
void refuse_overlaps(const std::vector<ThickPolygon>& thick) {
  std::vector<Polygon> polygons;
  for (const ThickPolygon& one : thick) polygons.push_back(one.polygon);
  for (const Overlap& overlap : overlaps(polygons))
    throw CaseError("release.polygon",
                    fmt::format("polygons {} and {} overlap by {:.3g} m2", overlap.first + 1,
                                overlap.second + 1, overlap.area),
                    "join them, or cut one out of the other");
}

/// Polygons with the thickness that an attribute of each says.
std::vector<ThickPolygon> read_thick_polygons(const ReleaseCase& release, const Frame& frame) {
  std::vector<ThickPolygon> thick;
  for (ValuedPolygon& valued :
       read_valued_polygons(release.polygon.file, frame.crs, "release.thickness_attribute",
                            release.thickness_attribute)) {
    if (!(valued.value > 0 && valued.value <= 1e4)) {
      throw CaseError("release.thickness_attribute",
                      fmt::format("{} has a polygon with {} = {:g}", release.polygon.file.string(),
                                  release.thickness_attribute, valued.value),
                      "give a thickness above 0, in m");
    }
    to_frame(frame, valued.polygon);
    thick.push_back({std::move(valued.polygon), valued.value});
  }
  return thick;
}

ReleaseShape polygon_shape(const ReleaseCase& release, const Frame& frame) {
  std::vector<ThickPolygon> thick;
  if (!release.thickness_attribute.empty()) {
    thick = read_thick_polygons(release, frame);
  } else {
    for (Polygon& polygon : read_area(release.polygon, "release.polygon", frame))
      thick.push_back({std::move(polygon), release.thickness.value_or(1)});
  }
  refuse_overlaps(thick);
  return release_of(std::move(thick));
}

ReleaseShape raster_shape(const Case& c, const Frame& frame) {
  Raster thickness = read_thickness(
      c.release.thickness_raster, {"release.thickness_raster", frame.crs, c.terrain.assume_metres});
  to_frame(frame, thickness.grid);
  return release_of(std::move(thickness));
}

ReleaseShape release_shape(const Case& c, const Scene& scene) {
  ReleaseShape shape = scene.lost                   ? release_of(scene.lost->thickness)
                       : !c.release.polygon.given() ? raster_shape(c, scene.frame)
                                                    : polygon_shape(c.release, scene.frame);
  if (c.release.normal) shape = made_vertical(shape, *scene.surface, c.numerics.spacing);
  return c.release.volume ? scaled_to(shape, *c.release.volume) : shape;
}

Bounds box_of(const std::array<double, 6>& box, const Frame& frame) {
  return {in_frame(frame, {box[0], box[1], box[2]}), in_frame(frame, {box[3], box[4], box[5]})};
}

/// Places in plan at which particles stand.
std::size_t columns_of(const Particles& particles) {
  std::vector<std::pair<double, double>> columns;
  for (const Vec3d& x : particles.position) columns.emplace_back(x.x, x.y);
  std::ranges::sort(columns);
  // Clang 14 does not read the ranges::unique of libstdc++ 12.
  return static_cast<std::size_t>(std::unique(columns.begin(), columns.end()) - columns.begin());
}

/// Particles, and what each of their columns stands for in plan.
struct Placed {
  Particles particles;
  double column_area = 0;  // m2
};

Placed released_by(const Case& c, const Scene& scene) {
  const double spacing = c.numerics.spacing;
  const ReleaseSettings settings{spacing, c.material.density, scene.frame};
  if (c.release.box) {
    const Bounds box = box_of(*c.release.box, scene.frame);
    const BoxColumns columns = box_columns(box, spacing);
    return {released_box(*scene.surface, box, scene.bodies, settings), columns.dx * columns.dy};
  }
  if (c.release.points.empty()) {
    const ReleaseShape shape = release_shape(c, scene);
    Particles particles = released(*scene.surface, shape, settings);
    const double area = shape.area / static_cast<double>(columns_of(particles));
    return {std::move(particles), area};
  }
  const auto& offset = c.release.points_offset;
  std::vector<Vec3d> points = read_points(c.release.points, Vec3d{offset[0], offset[1], offset[2]});
  for (Vec3d& point : points) point = in_frame(scene.frame, point);
  return {released(*scene.surface, points, c.release.point_volume, settings), spacing * spacing};
}

/// Gives the fluid of a box the pressure under its level surface.
void make_level_hydrostatic(const Case& c, Scene& scene) {
  Particles& release = scene.release;
  const double top = (*c.release.box)[5];
  const auto lowest = std::min_element(release.position.begin(), release.position.end(),
                                       [](const Vec3d& a, const Vec3d& b) { return a.z < b.z; });
  scene.release_depth = top - lowest->z + c.numerics.spacing / 2;
  const Tait state = flow_model(c.material, c.numerics, scene.greatest_depth()).state;
  for (std::size_t i = 0; i < release.size(); ++i)
    release.density[i] =
        state.density(state.rho0 * c.numerics.gravity * (top - release.position[i].z));
}

/// Gives the release the pressure of its own weight on a slope, p = rho g d cos^2(theta) with the
/// vertical depth d below the top of its column, so that it does not start with a thud.
void make_hydrostatic(const Case& c, Scene& scene) {
  Particles& release = scene.release;
  const double dp = c.numerics.spacing;
  const auto column_of = [&](const Vec3d& x) {
    return std::pair{std::floor(x.x / dp), std::floor(x.y / dp)};
  };
  std::map<std::pair<double, double>, double> top;
  for (std::size_t i = 0; i < release.size(); ++i) {
    const Vec3d& x = release.position[i];
    const double height = release.mass[i] / (c.material.density * dp * dp);  // that it stands for
    double& highest = top.try_emplace(column_of(x), x.z).first->second;
    highest = std::max(highest, x.z + 0.5 * height);
  }
  for (const Vec3d& x : release.position)
    scene.release_depth =
        std::max(scene.release_depth, top.at(column_of(x)) - scene.surface->height(x.x, x.y));

  const Tait state = flow_model(c.material, c.numerics, scene.greatest_depth()).state;
  for (std::size_t i = 0; i < release.size(); ++i) {
    const Vec3d& x = release.position[i];
    const double depth = top.at(column_of(x)) - x.z;
    const double cosine = scene.surface->normal(x.x, x.y).z;
    release.density[i] = state.density(state.rho0 * c.numerics.gravity * depth * cosine * cosine);
  }
}

/// Whether a particle would stand in a structure or body, or with a quarter of it in one.
bool is_in_solid(const Scene& scene, const Vec3d& x, double spacing) {
  const double reach = spacing / 4;
  return scene.is_solid(x) || scene.is_solid(x + Vec3d{reach, 0, 0}) ||
         scene.is_solid(x - Vec3d{reach, 0, 0}) || scene.is_solid(x + Vec3d{0, reach, 0}) ||
         scene.is_solid(x - Vec3d{0, reach, 0});
}

/// A mass has no place inside of structures.
void leave_out_of_solids(const Case& c, Scene& scene) {
  Particles& release = scene.release;
  std::vector<std::uint32_t> staying;
  for (std::uint32_t i = 0; i < release.size(); ++i) {
    if (!is_in_solid(scene, release.position[i], c.numerics.spacing)) {
      staying.push_back(i);
      continue;
    }
    scene.release_left_out += release.mass[i] / c.material.density;
  }
  if (staying.size() == release.size()) return;
  if (staying.empty())
    throw CaseError("release", "all of it lies inside of structures or bodies", "move it, or them");
  release.permute(staying);
  for (std::uint32_t i = 0; i < release.size(); ++i) release.id[i] = i;
}

void summarise(const Case& c, Scene& scene) {
  double mass = 0;
  scene.release_centre = {};
  for (std::size_t i = 0; i < scene.release.size(); ++i) {
    mass += scene.release.mass[i];
    scene.release_centre += scene.release.mass[i] * scene.release.position[i];
  }
  scene.release_centre *= 1 / mass;
  scene.release_volume = mass / c.material.density;
}

}  // namespace

void read_release(const Case& c, Scene& scene) {
  Placed placed = released_by(c, scene);
  scene.release = std::move(placed.particles);
  if (!scene.dams.empty() || !scene.bodies.empty()) leave_out_of_solids(c, scene);
  scene.release_area = placed.column_area * static_cast<double>(columns_of(scene.release));
  summarise(c, scene);
  c.release.box ? make_level_hydrostatic(c, scene) : make_hydrostatic(c, scene);
  // Last, so that path, sound speed and densities are the same for every seed.
  const double reach = c.release.jitter * c.numerics.spacing;
  const auto seed = static_cast<std::uint64_t>(c.release.seed);
  jitter(scene.release, *scene.surface, {reach, 0.2 * c.numerics.spacing, seed});
}

}  // namespace sabo
