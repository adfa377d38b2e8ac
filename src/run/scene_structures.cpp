#include "run/scene_structures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/gis/read_vectors.hpp"
#include "run/dam_openings.hpp"
#include "run/scene_lines.hpp"
#include "terrain/dam_mesh.hpp"
#include "terrain/polygon_checks.hpp"

namespace sabo {
namespace {

constexpr double largest_joint = 0.5;  // of the smaller of two dams: walls may meet and cross
constexpr double most_profile_pieces = 1e5;

/// Of a dam whose height counts from the lowest ground along its line, m.
double level_crest(const CheckDam& dam, const Surface& surface, double height) {
  const double span = length(dam.axis);
  const int samples = std::max(2, static_cast<int>(span / surface.elevation().grid.dx));
  double lowest = surface.height(dam.axis.vertices[0].x, dam.axis.vertices[0].y);
  for (int k = 1; k <= samples; ++k) {
    const Vec3d at = point_at(dam.axis, span * k / samples);
    lowest = std::min(lowest, surface.height(at.x, at.y));
  }
  return lowest + height;
}

/// Crest of a wall whose height counts from the ground under each of its stations, m.
std::vector<double> crest_along(const CheckDam& wall, const Surface& surface, double height) {
  const Grid& grid = surface.elevation().grid;
  const double span = length(wall.axis);
  const double pieces =
      std::clamp(std::ceil(2 * span / std::min(grid.dx, grid.dy)), 1.0, most_profile_pieces);
  std::vector<double> profile;
  for (int k = 0; k <= pieces; ++k) {
    const Vec3d at = point_at(wall.axis, span * k / pieces);
    profile.push_back(surface.height(at.x, at.y) + height);
  }
  return profile;
}

/// A notch may be too narrow: the dam is overtopped beside it.
void refuse_narrow_openings(const StructureCase& c, const std::string& key, double spacing) {
  for (const ClearWidth& clear : clear_widths(c)) {
    if (clear.key.starts_with("notch")) continue;
    if (clear.width >= enough_across / 2 * spacing * (1 - 1e-9)) continue;
    throw CaseError(fmt::format("{}.{}", key, clear.key),
                    fmt::format("{:g} m is less than {:g} particle spacings of {:g} m, so that "
                                "nothing can pass",
                                clear.width, enough_across / 2, spacing),
                    fmt::format("give a wider opening, or numerics.spacing = {:.3g} m for {:g} "
                                "particles across",
                                clear.width / enough_across, enough_across));
  }
}

/// A dam whose crest lies below the ground all along its line would not be there.
void refuse_buried(const CheckDam& dam, const std::string& key, const Surface& surface) {
  const Grid& grid = surface.elevation().grid;
  const double span = length(dam.axis);
  const double pieces =
      std::clamp(std::ceil(2 * span / std::min(grid.dx, grid.dy)), 1.0, most_profile_pieces);
  double highest = -std::numeric_limits<double>::infinity();  // above the ground
  for (int k = 0; k <= pieces; ++k) {
    const double station = span * k / pieces;
    const Vec3d at = point_at(dam.axis, station);
    highest =
        std::max(highest, dam.top(station) + dam.notch_depth(station) - surface.height(at.x, at.y));
  }
  if (highest <= 0)
    throw CaseError(key,
                    fmt::format("the crest of \"{}\" lies below the ground all along", dam.name),
                    "give crest as an elevation of the DEM, or height above the ground, in m");
}

CheckDam make_dam(const StructureCase& c, const std::string& key, const Scene& scene,
                  double spacing) {
  CheckDam dam;
  dam.name = c.name;
  dam.axis = read_line(c.line, key + ".line", scene);
  dam.thickness = c.thickness.value_or(0);
  if (c.notch)
    dam.notch = Notch{c.notch->centre, c.notch->width, c.notch->depth, c.notch->side_slope};
  if (c.crest || c.height) dam.axis.has_z = false;
  if (c.crest) dam.crest = *c.crest;
  if (!c.crest && !c.height && !dam.axis.has_z)
    throw CaseError(key, "the line has no z, and neither crest nor height is given",
                    "give crest (elevation, m) or height (above the ground, m)");
  if (c.height && c.kind == StructureKind::deflection_wall)
    dam.profile = crest_along(dam, *scene.surface, *c.height);
  else if (c.height)
    dam.crest = level_crest(dam, *scene.surface, *c.height);
  refuse_buried(dam, key, *scene.surface);
  refuse_narrow_openings(c, key, spacing);
  dam.openings = dam_openings(c, dam, *scene.surface, key);
  return dam;
}

/// Outlines with their heights, in the coordinates of the DEM.
std::vector<ValuedPolygon> read_outlines(const StructureCase& c, const std::string& key,
                                         const Scene& scene) {
  const std::string polygon = key + ".polygon";
  std::vector<ValuedPolygon> outlines;
  if (!c.height_attribute.empty()) {
    outlines = read_valued_polygons(c.polygon.file, scene.frame.crs, key + ".height_attribute",
                                    c.height_attribute);
  } else if (!c.polygon.file.empty()) {
    for (Polygon& outline : read_polygons(c.polygon.file, scene.frame.crs, polygon))
      outlines.push_back({std::move(outline), c.height.value_or(0)});
  } else {
    outlines.push_back({drawn_polygon(c.polygon, polygon), c.height.value_or(0)});
  }
  return outlines;
}

void refuse_outside(const Building& building, const Scene& scene, const std::string& key) {
  for (const std::vector<Vec3d>& ring : building.outline.rings) {
    for (const Vec3d& corner : ring) {
      if (scene.surface->inside(corner.x, corner.y)) continue;
      throw CaseError(
          key,
          fmt::format("\"{}\" has a corner outside the DEM at ({:.2f}, {:.2f})", building.name,
                      corner.x + scene.frame.origin_x, corner.y + scene.frame.origin_y),
          "remove it, or take a larger DEM");
    }
  }
}

void add_buildings(const StructureCase& c, const std::string& key, Scene& scene) {
  std::vector<ValuedPolygon> outlines = read_outlines(c, key, scene);
  const bool is_alone = outlines.size() == 1;
  std::size_t number = 0;
  for (ValuedPolygon& outline : outlines) {
    ++number;
    Building building{is_alone ? c.name : fmt::format("{} {}", c.name, number), c.name,
                      std::move(outline.polygon)};
    if (!(outline.value > 0 && outline.value <= 1e4))
      throw CaseError(
          key + ".height_attribute",
          fmt::format("{} has a building, number {}, with {} = {:g}", c.polygon.file.string(),
                      number, c.height_attribute, outline.value),
          "give a height above 0, in m");
    to_frame(scene.frame, building.outline);
    refuse_outside(building, scene, key + ".polygon");
    building.bottom = lowest_ground(*scene.surface, building.outline);
    building.top = building.bottom + outline.value;
    scene.buildings.push_back(std::move(building));
  }
}

/// Buildings may share walls, but not ground.
void check_overlaps(const std::vector<Building>& buildings, Faults& faults) {
  std::vector<Polygon> outlines;
  for (const Building& building : buildings) outlines.push_back(building.outline);
  for (const Overlap& overlap : overlaps(outlines))
    faults.add("structure",
               fmt::format("\"{}\" and \"{}\" overlap by {:.3g} m2", buildings[overlap.first].name,
                           buildings[overlap.second].name, overlap.area),
               "join their polygons, or move one");
}

/// A dam in plan: a rectangle for each piece of its line.
struct Plan {
  std::vector<Polygon> pieces;
  double area = 0;  // m2
};

Plan plan_of(const CheckDam& dam) {
  Plan plan;
  for (std::size_t k = 0; k + 1 < dam.axis.vertices.size(); ++k) {
    const Vec3d &a = dam.axis.vertices[k], &b = dam.axis.vertices[k + 1];
    const double span = std::hypot(b.x - a.x, b.y - a.y);
    if (!(span > 0)) continue;
    const Vec3d aside = dam.thickness / (2 * span) * Vec3d{a.y - b.y, b.x - a.x, 0};
    plan.pieces.push_back({{{a + aside, a - aside, b - aside, b + aside}}});
    plan.area += span * dam.thickness;
  }
  return plan;
}

double shared_area(const Plan& a, const Plan& b) {
  double shared = 0;
  for (const Polygon& of_a : a.pieces)
    for (const Polygon& of_b : b.pieces) shared += shared_area(of_a, of_b);
  return shared;
}

/// Where two stand in one place, forces and volumes are those of the first: no more than a joint.
void check_overlaps(const std::vector<CheckDam>& dams, Faults& faults) {
  std::vector<Plan> plans;
  for (const CheckDam& dam : dams) plans.push_back(plan_of(dam));
  for (std::size_t i = 0; i < dams.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double shared = shared_area(plans[i], plans[j]);
      if (shared <= largest_joint * std::min(plans[i].area, plans[j].area)) continue;
      faults.add("structure",
                 fmt::format("\"{}\" and \"{}\" stand in one place: {:.3g} m2 in common",
                             dams[j].name, dams[i].name, shared),
                 "move one, or leave it out; walls may meet, and cross each other");
    }
  }
}

}  // namespace

void read_structures(const Case& c, Scene& scene, Faults& faults) {
  for (const StructureKind kind :
       {StructureKind::check_dam, StructureKind::deflection_wall, StructureKind::building}) {
    for (std::size_t k = 0; k < c.structures.size(); ++k) {
      const StructureCase& structure = c.structures[k];
      if (structure.kind != kind) continue;
      const std::string key = fmt::format("structure[{}]", k + 1);
      collected(faults, [&] {
        if (kind == StructureKind::building) return add_buildings(structure, key, scene);
        scene.dams.push_back(make_dam(structure, key, scene, c.numerics.spacing));
        if (kind == StructureKind::deflection_wall) ++scene.deflection_walls;
      });
    }
  }
  check_overlaps(scene.buildings, faults);
  check_overlaps(scene.dams, faults);
}

std::vector<ClearWidth> clear_widths(const StructureCase& dam) {
  std::vector<ClearWidth> widths;
  if (dam.notch) widths.push_back({"notch.width", dam.notch->width});
  for (std::size_t k = 0; k < dam.slits.size(); ++k) {
    const std::string key = fmt::format("slit[{}]", k + 1);
    widths.push_back({key + ".width", dam.slits[k].width});
    if (dam.slits[k].height) widths.push_back({key + ".height", *dam.slits[k].height});
  }
  for (std::size_t k = 0; k < dam.grids.size(); ++k) {
    const std::string key = fmt::format("grid[{}]", k + 1);
    widths.push_back({key + ".gap", dam.grids[k].gap});
    if (dam.grids[k].beam_gap) widths.push_back({key + ".beam_gap", *dam.grids[k].beam_gap});
  }
  return widths;
}

TriangleMesh shown_mesh(const CheckDam& dam, const Scene& scene) {
  const Grid& grid = scene.surface->elevation().grid;
  // Some way into the ground, of which pictures may show a coarser mesh.
  return dam_mesh(dam, *scene.surface, 2 * std::max(grid.dx, grid.dy));
}

}  // namespace sabo
