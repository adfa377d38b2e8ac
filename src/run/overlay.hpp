#pragma once

#include <string>
#include <vector>

#include "io/output/map_picture.hpp"
#include "run/scene.hpp"

namespace sabo {

/// How a dam is drawn: as the stretches that stand, or as all of its axis.
enum class DamLine { standing, whole };

/// Path, zones, dams, bodies, inflows and sections of a scene as lines over a map, in the solver
/// frame. An inflow has an arrow, too, unless dams are whole.
std::vector<MapLine> overlay(const Scene& scene, DamLine dams = DamLine::standing);

/// What pictures call a body of the scene; of many buildings the first of each structure only has
/// a label.
std::string label_of_body(const Scene& scene, std::size_t index);

/// Outline of a body of the scene in plan.
Polygon outline_of_body(const Scene& scene, std::size_t index);

/// Appends the outlines of the polygons of one thing; the label stands at the first.
void add_outlines(MapLine::Kind kind, const std::string& name, const std::string& label,
                  const std::vector<Polygon>& polygons, std::vector<MapLine>& lines);

}  // namespace sabo
