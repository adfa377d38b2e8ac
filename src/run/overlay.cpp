#include "run/overlay.hpp"

#include "geometry/plan_outline.hpp"

namespace sabo {

void add_outlines(MapLine::Kind kind, const std::string& label,
                  const std::vector<Polygon>& polygons, std::vector<MapLine>& lines) {
  bool is_first = true;
  for (const Polygon& polygon : polygons) {
    for (std::vector<Vec3d> ring : polygon.rings) {
      if (ring.empty()) continue;
      ring.push_back(ring.front());
      lines.push_back({kind, is_first ? label : "", {std::move(ring), false}});
      is_first = false;
    }
  }
}

std::vector<MapLine> overlay(const Scene& scene) {
  std::vector<MapLine> lines;
  lines.push_back({MapLine::Kind::path, "", scene.path});
  for (const NamedZone& zone : scene.zones)
    add_outlines(MapLine::Kind::zone, zone.name, zone.polygons, lines);
  for (const CheckDam& dam : scene.dams) lines.push_back({MapLine::Kind::dam, dam.name, dam.axis});
  for (const Body& body : scene.bodies)
    add_outlines(MapLine::Kind::dam, body.name(), {{{plan_outline(body.mesh())}}}, lines);
  for (const NamedSection& section : scene.sections)
    lines.push_back({MapLine::Kind::section, section.name, section.line});
  return lines;
}

}  // namespace sabo
