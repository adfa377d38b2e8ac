#include "run/scene.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "base/error.hpp"
#include "io/gis/read_dem.hpp"
#include "io/gis/read_points.hpp"
#include "io/gis/read_thickness.hpp"
#include "io/gis/read_vectors.hpp"
#include "solver/flow_model.hpp"
#include "terrain/release.hpp"
#include "terrain/steepest_descent.hpp"

namespace sabo {
namespace {

/// Runs one part of the reading; its faults join the others.
bool collected(Faults& faults, const std::function<void()>& part) {
  try {
    part();
    return true;
  } catch (const CaseError& error) {
    for (const Fault& fault : error.faults()) faults.add(fault.place, fault.problem, fault.remedy);
    return false;
  }
}

Vec3d moved(const Frame& frame, Vec3d x) { return x - Vec3d{frame.origin_x, frame.origin_y, 0}; }

void move(const Frame& frame, Grid& grid) {
  grid.west -= frame.origin_x;
  grid.north -= frame.origin_y;
}

void read_terrain(const TerrainCase& c, Scene& scene) {
  Dem dem = read_dem({.file = c.dem, .assume_metres = c.assume_metres, .crop = c.crop});
  scene.frame = {std::floor(dem.raster.grid.west), std::floor(dem.raster.grid.south()),
                 dem.crs_wkt};
  move(scene.frame, dem.raster.grid);
  scene.holes = fill_holes(dem.raster, static_cast<int>(c.fill_holes));
  scene.surface = std::make_unique<Surface>(std::move(dem.raster));
}

Polyline read_line(const LineSource& source, const std::string& key, const Frame& frame) {
  Polyline line;
  if (!source.file.empty()) {
    std::vector<Polyline> lines = read_lines(source.file, frame.crs, key);
    if (lines.size() != 1)
      throw CaseError(
          key,
          source.file.string() + " holds " + std::to_string(lines.size()) + " lines, one is wanted",
          "leave one line in the file, or give coordinates");
    line = std::move(lines.front());
  } else {
    for (const auto& c : source.coordinates) line.vertices.push_back({c[0], c[1], c[2]});
    line.has_z = source.has_z;
  }
  for (Vec3d& vertex : line.vertices) vertex = moved(frame, vertex);
  return line;
}

std::vector<Polygon> read_release_polygons(const LineSource& source, const Frame& frame) {
  std::vector<Polygon> polygons;
  if (!source.file.empty()) {
    polygons = read_polygons(source.file, frame.crs, "release.polygon");
  } else {
    std::vector<Vec3d> ring;
    for (const auto& c : source.coordinates) ring.push_back({c[0], c[1], c[2]});
    polygons.push_back({{ring}});
  }
  for (Polygon& polygon : polygons)
    for (std::vector<Vec3d>& ring : polygon.rings)
      for (Vec3d& vertex : ring) vertex = moved(frame, vertex);
  return polygons;
}

ReleaseShape release_shape(const Case& c, const Scene& scene) {
  ReleaseShape shape;
  if (c.release.polygon.given()) {
    shape = release_of(read_release_polygons(c.release.polygon, scene.frame),
                       c.release.thickness.value_or(1));
  } else {
    Raster thickness =
        read_thickness(c.release.thickness_raster, scene.frame.crs, c.terrain.assume_metres);
    move(scene.frame, thickness.grid);
    shape = release_of(std::move(thickness));
  }
  if (c.release.normal) shape = made_vertical(shape, *scene.surface, c.numerics.spacing);
  return c.release.volume ? scaled_to(shape, *c.release.volume) : shape;
}

Particles read_release(const Case& c, const Scene& scene) {
  const ReleaseSettings settings{c.numerics.spacing, c.material.density, scene.frame};
  if (c.release.points.empty()) return released(*scene.surface, release_shape(c, scene), settings);
  const auto& offset = c.release.points_offset;
  std::vector<Vec3d> points = read_points(c.release.points, Vec3d{offset[0], offset[1], offset[2]});
  for (Vec3d& point : points) point = moved(scene.frame, point);
  return released(*scene.surface, points, c.release.point_volume, settings);
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
  for (const Vec3d& x : release.position) {
    const auto [entry, is_new] = top.try_emplace(column_of(x), x.z);
    if (!is_new) entry->second = std::max(entry->second, x.z);
  }
  for (const Vec3d& x : release.position)
    scene.release_depth = std::max(
        scene.release_depth, top.at(column_of(x)) + 0.5 * dp - scene.surface->height(x.x, x.y));

  const Tait state = flow_model(c.material, c.numerics, scene.release_depth).state;
  for (std::size_t i = 0; i < release.size(); ++i) {
    const Vec3d& x = release.position[i];
    const double depth = top.at(column_of(x)) + 0.5 * dp - x.z;
    const double cosine = scene.surface->normal(x.x, x.y).z;
    release.density[i] = state.density(state.rho0 * c.numerics.gravity * depth * cosine * cosine);
  }
}

void summarise_release(const Case& c, Scene& scene) {
  double mass = 0;
  for (std::size_t i = 0; i < scene.release.size(); ++i) {
    mass += scene.release.mass[i];
    scene.release_centre += scene.release.mass[i] * scene.release.position[i];
  }
  scene.release_centre *= 1 / mass;
  scene.release_volume = mass / c.material.density;
}

CheckDam make_dam(const StructureCase& c, const std::string& key, const Scene& scene) {
  CheckDam dam;
  dam.name = c.name;
  dam.axis = read_line(c.line, key + ".line", scene.frame);
  dam.thickness = c.thickness;
  if (c.notch)
    dam.notch = Notch{c.notch->centre, c.notch->width, c.notch->depth, c.notch->side_slope};
  if (c.crest || c.height) dam.axis.has_z = false;
  if (c.crest) dam.crest = *c.crest;
  if (!c.crest && !c.height && !dam.axis.has_z)
    throw CaseError(key, "the line has no z, and neither crest nor height is given",
                    "give crest (elevation, m) or height (above the lowest ground, m)");
  if (c.height) {
    const double span = length(dam.axis);
    const int samples = std::max(2, static_cast<int>(span / scene.surface->elevation().grid.dx));
    double lowest = scene.surface->height(dam.axis.vertices[0].x, dam.axis.vertices[0].y);
    for (int k = 1; k <= samples; ++k) {
      const Vec3d at = point_at(dam.axis, span * k / samples);
      lowest = std::min(lowest, scene.surface->height(at.x, at.y));
    }
    dam.crest = lowest + *c.height;
  }
  return dam;
}

void read_structures(const Case& c, Scene& scene, Faults& faults) {
  for (std::size_t k = 0; k < c.structures.size(); ++k) {
    const std::string key = "structure[" + std::to_string(k + 1) + "]";
    collected(faults, [&] { scene.dams.push_back(make_dam(c.structures[k], key, scene)); });
  }
}

void read_sections(const Case& c, Scene& scene, Faults& faults) {
  for (std::size_t k = 0; k < c.sections.size(); ++k) {
    const std::string key = "section[" + std::to_string(k + 1) + "].line";
    collected(faults, [&] {
      scene.sections.push_back(
          {c.sections[k].name, read_line(c.sections[k].line, key, scene.frame)});
    });
  }
}

}  // namespace

Scene make_scene(const Case& c, Faults& faults) {
  Scene scene;
  if (!collected(faults, [&] { read_terrain(c.terrain, scene); })) return scene;
  read_structures(c, scene, faults);
  read_sections(c, scene, faults);
  const bool has_release = collected(faults, [&] {
    scene.release = read_release(c, scene);
    summarise_release(c, scene);
    make_hydrostatic(c, scene);
  });
  collected(faults, [&] {
    if (c.path.line.given()) {
      scene.path = read_line(c.path.line, "path.line", scene.frame);
    } else if (has_release) {
      scene.path_is_descent = true;
      scene.path = steepest_descent(scene.surface->elevation(), scene.release_centre.x,
                                    scene.release_centre.y);
    }
  });
  return scene;
}

}  // namespace sabo
