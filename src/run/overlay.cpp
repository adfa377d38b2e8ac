#include "run/overlay.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/plan_outline.hpp"

namespace sabo {
namespace {

constexpr std::size_t most_labels = 12;  // of buildings: more hide the map

/// Whether a dam is open from the ground or its sill to the crest at a station.
bool is_cut(const CheckDam& dam, double station) {
  return std::ranges::any_of(dam.openings, [&](const Opening& opening) {
    return station > opening.from && station < opening.to && opening.core == 0 &&
           std::isinf(opening.top);
  });
}

/// The axis, without its openings that have nothing above them.
void add_dam(const CheckDam& dam, std::vector<MapLine>& lines) {
  const std::vector<double> stations = dam_stations(dam);
  const std::size_t first = lines.size();
  bool goes_on = false;
  for (std::size_t k = 1; k < stations.size(); ++k) {
    const bool is_solid = !is_cut(dam, (stations[k - 1] + stations[k]) / 2);
    if (is_solid && !goes_on)
      lines.push_back({MapLine::Kind::dam,
                       lines.size() == first ? dam.name : "",
                       {{point_at(dam.axis, stations[k - 1])}, false},
                       false,
                       dam.name});
    if (is_solid) lines.back().line.vertices.push_back(point_at(dam.axis, stations[k]));
    goes_on = is_solid;
  }
}

/// Which way an inflow goes, from the middle of its columns.
Polyline arrow_of(const InflowPlan& inflow) {
  const std::vector<Vec3d>& columns = inflow.section.columns();
  const double width = inflow.section.column_width() * static_cast<double>(columns.size());
  const double size = std::max(inflow.reach, 0.35 * width);
  const Vec3d& ahead = inflow.section.direction();
  const Vec3d aside{-ahead.y, ahead.x, 0};
  const Vec3d foot = columns[columns.size() / 2];
  const Vec3d tip = foot + size * ahead;
  const auto barb = [&](double side) { return tip - 0.3 * size * (ahead + side * aside); };
  return {{foot, tip, barb(0.7), tip, barb(-0.7)}, false};
}

}  // namespace

void add_outlines(MapLine::Kind kind, const std::string& name, const std::string& label,
                  const std::vector<Polygon>& polygons, std::vector<MapLine>& lines) {
  bool is_first = true;
  for (const Polygon& polygon : polygons) {
    for (std::vector<Vec3d> ring : polygon.rings) {
      if (ring.empty()) continue;
      ring.push_back(ring.front());
      lines.push_back({kind, is_first ? label : "", {std::move(ring), false}, false, name});
      is_first = false;
    }
  }
}

std::string label_of_body(const Scene& scene, std::size_t index) {
  const std::size_t others = scene.bodies.size() - scene.buildings.size();
  if (index < others || scene.buildings.size() <= most_labels) return scene.bodies[index].name();
  const std::size_t k = index - others;
  const bool is_first = k == 0 || scene.buildings[k - 1].group != scene.buildings[k].group;
  return is_first ? scene.buildings[k].group : "";
}

Polygon outline_of_body(const Scene& scene, std::size_t index) {
  const std::size_t others = scene.bodies.size() - scene.buildings.size();
  if (index < others) return {{plan_outline(scene.bodies[index].mesh())}};
  return scene.buildings[index - others].outline;
}

std::vector<MapLine> overlay(const Scene& scene, DamLine dams) {
  std::vector<MapLine> lines;
  lines.push_back({MapLine::Kind::path, "", scene.path, false, "path"});
  for (const NamedZone& zone : scene.zones)
    add_outlines(MapLine::Kind::zone, zone.name, zone.name, zone.polygons, lines);
  for (const CheckDam& dam : scene.dams)
    dams == DamLine::whole ? lines.push_back({MapLine::Kind::dam, dam.name, dam.axis})
                           : add_dam(dam, lines);
  const std::size_t others = scene.bodies.size() - scene.buildings.size();
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const std::size_t first = lines.size();
    const Polygon outline = outline_of_body(scene, k);
    add_outlines(MapLine::Kind::dam, scene.bodies[k].name(), label_of_body(scene, k), {outline},
                 lines);
    lines[first].is_filled = k >= others && outline.rings.size() == 1;
  }
  for (const InflowPlan& inflow : scene.inflows) {
    lines.push_back({MapLine::Kind::inflow, inflow.name, inflow.line});
    if (dams == DamLine::standing)
      lines.push_back({MapLine::Kind::inflow, "", arrow_of(inflow), false, inflow.name});
  }
  for (const NamedSection& section : scene.sections)
    lines.push_back({MapLine::Kind::section, section.name, section.line});
  return lines;
}

}  // namespace sabo
