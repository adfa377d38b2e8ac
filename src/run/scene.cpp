#include "run/scene.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "analysis/zone.hpp"
#include "base/error.hpp"
#include "io/gis/read_vectors.hpp"
#include "run/scene_bodies.hpp"
#include "run/scene_inflows.hpp"
#include "run/scene_lines.hpp"
#include "run/scene_release.hpp"
#include "run/scene_structures.hpp"
#include "run/scene_terrain.hpp"
#include "terrain/steepest_descent.hpp"

namespace sabo {
namespace {

void read_zones(const Case& c, Scene& scene, Faults& faults) {
  for (std::size_t k = 0; k < c.zones.size(); ++k) {
    const std::string key = fmt::format("zone[{}].polygon", k + 1);
    collected(faults, [&] {
      std::vector<Polygon> polygons = read_area(c.zones[k].polygon, key, scene.frame);
      if (Zone(scene.surface->elevation(), polygons).is_empty()) {
        throw CaseError(key, "holds no centre of a cell with data",
                        "check its coordinates, or give a larger polygon");
      }
      scene.zones.push_back({c.zones[k].name, std::move(polygons)});
    });
  }
}

void read_sections(const Case& c, Scene& scene, Faults& faults) {
  for (std::size_t k = 0; k < c.sections.size(); ++k) {
    const std::string key = fmt::format("section[{}].line", k + 1);
    collected(faults, [&] {
      scene.sections.push_back({c.sections[k].name, read_line(c.sections[k].line, key, scene)});
    });
  }
}

void add_gauges(const GaugeCase& gauge, const std::string& key, Scene& scene) {
  std::vector<Vec3d> places;
  if (gauge.place) places = {{(*gauge.place)[0], (*gauge.place)[1], 0}};
  if (!gauge.file.empty()) places = read_points(gauge.file, scene.frame.crs, key + ".file");
  for (std::size_t k = 0; k < places.size(); ++k) {
    Vec3d place = in_frame(scene.frame, places[k]);
    const std::string name =
        places.size() > 1 ? fmt::format("{} {}", gauge.name, k + 1) : gauge.name;
    if (!scene.surface->inside(place.x, place.y))
      throw CaseError(key, fmt::format("\"{}\" lies outside of the DEM", name),
                      "check its coordinates, which are those of the DEM");
    place.z = gauge.elevation.value_or(scene.surface->height(place.x, place.y));
    scene.gauges.push_back({name, place});
  }
}

void read_gauges(const Case& c, Scene& scene, Faults& faults) {
  for (std::size_t k = 0; k < c.gauges.size(); ++k)
    collected(faults, [&] { add_gauges(c.gauges[k], fmt::format("gauge[{}]", k + 1), scene); });
}

/// Every dam and body has a name of its own, under which the outputs have it.
void check_names(const Scene& scene, Faults& faults) {
  std::set<std::string> names;
  const auto check = [&](const std::string& name) {
    if (names.insert(name).second) return;
    faults.add("structure", fmt::format("\"{}\" is the name of two structures or bodies", name),
               "give each its own name; several buildings of one file get a number behind it");
  };
  for (const CheckDam& dam : scene.dams) check(dam.name);
  for (const Body& body : scene.bodies) check(body.name());
  if (names.size() > most_bodies)
    faults.add("structure", fmt::format("there are {} structures and bodies", names.size()),
               "leave out those that the flow does not reach");
}

/// On level ground the front is measured along the axis on which it can go farthest.
Polyline level_path(const Scene& scene) {
  const Grid& grid = scene.surface->elevation().grid;
  const Vec3d& from = scene.release_centre;
  const double west = grid.x_of(0), east = grid.x_of(grid.columns - 1);
  const double north = grid.y_of(0), south = grid.y_of(grid.rows - 1);
  const std::pair<double, Vec3d> ways[] = {{east - from.x, {east, from.y, 0}},
                                           {from.x - west, {west, from.y, 0}},
                                           {north - from.y, {from.x, north, 0}},
                                           {from.y - south, {from.x, south, 0}}};
  const auto farthest =
      std::max_element(std::begin(ways), std::end(ways),
                       [](const auto& a, const auto& b) { return a.first < b.first; });
  return {{{from.x, from.y, 0}, farthest->second}, false};
}

}  // namespace

bool collected(Faults& faults, const std::function<void()>& part) {
  try {
    part();
    return true;
  } catch (const CaseError& error) {
    for (const Fault& fault : error.faults()) faults.add(fault.place, fault.problem, fault.remedy);
    return false;
  }
}

bool Scene::is_solid(const Vec3d& place) const {
  const auto holds_it = [&](const auto& solid) { return solid.contains(place); };
  return std::ranges::any_of(dams, holds_it) || std::ranges::any_of(bodies, holds_it);
}

int Scene::side_of_release(const CheckDam& dam) const {
  return project(dam.axis, release_centre.x, release_centre.y).offset < 0 ? -1 : 1;
}

double Scene::greatest_depth() const {
  double depth = release_depth;
  for (const InflowPlan& inflow : inflows) depth = std::max(depth, inflow.highest_flow().depth);
  return depth;
}

std::size_t Scene::particles_until(double time) const {
  std::size_t count = release.size();
  for (const InflowPlan& inflow : inflows) count += inflow.particles_until(time);
  return count;
}

Scene make_scene(const Case& c, Faults& faults) {
  Scene scene;
  read_terrain(c, scene, faults);
  if (!scene.surface) return scene;
  read_structures(c, scene, faults);
  read_bodies(c, scene, faults);
  if (faults.empty()) check_names(scene, faults);
  read_sections(c, scene, faults);
  read_gauges(c, scene, faults);
  read_zones(c, scene, faults);
  const bool has_inflows = read_inflows(c, scene, faults);
  const bool has_release =
      (c.release.dem_before.empty() || scene.lost) &&  // else its fault is known already
      has_inflows && collected(faults, [&] {
        if (c.release.given()) read_release(c, scene);
        check_inflow_places(scene);
      });
  collected(faults, [&] {
    if (c.path.line.given()) {
      scene.path = read_line(c.path.line, "path.line", scene);
    } else if (has_release && c.terrain.plane && c.terrain.plane->slope == 0) {
      scene.path = level_path(scene);
    } else if (has_release) {
      scene.path_is_descent = true;
      scene.path = steepest_descent(scene.surface->elevation(), scene.release_centre.x,
                                    scene.release_centre.y);
    }
  });
  return scene;
}

}  // namespace sabo
