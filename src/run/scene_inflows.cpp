#include "run/scene_inflows.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/output/read_hydrograph.hpp"
#include "run/scene_lines.hpp"
#include "solver/flow_model.hpp"

namespace sabo {
namespace {

/// Falls that differ by less than this are no slope to choose a side by, m/m.
constexpr double level_slope = 1e-6;

Hydrograph discharge_of(const InflowCase& inflow, const std::string& key) {
  Hydrograph result = inflow.hydrograph.empty()
                          ? hydrograph_of(inflow.surges)
                          : read_hydrograph(inflow.hydrograph, key + ".hydrograph");
  if (inflow.speed && !result.speed.empty())
    throw CaseError(key + ".speed", "the hydrograph has speeds, too", "give it once");
  if (inflow.speed) result.speed.assign(result.time.size(), *inflow.speed);
  return result;
}

/// Whether the section has ground all the way that its particles are driven.
bool is_inside(const Scene& scene, const InflowSection& section, double reach) {
  const auto is_on_ground = [&](const Vec3d& x) {
    const Vec3d end = x + reach * section.direction();
    return scene.surface->inside(x.x, x.y) && scene.surface->inside(end.x, end.y);
  };
  return std::ranges::all_of(section.columns(), is_on_ground);
}

/// Both ways across a line; one that leads out of the DEM is none.
InflowSection section_of(const InflowCase& inflow, const Scene& scene, const Polyline& line,
                         double spacing, double reach, const std::string& key) {
  if (InflowSection::turns_back(line))
    throw CaseError(key + ".line", "turns back, or its ends are at one place",
                    "draw it from one bank to the other");
  const auto is_outside = [&](const Vec3d& x) { return !scene.surface->inside(x.x, x.y); };
  if (std::ranges::any_of(line.vertices, is_outside))
    throw CaseError(key + ".line", "lies outside the DEM", "draw it where the DEM has data");
  const InflowSection left(*scene.surface, line, true, spacing, reach);
  const InflowSection right(*scene.surface, line, false, spacing, reach);
  const bool left_is_inside = is_inside(scene, left, reach);
  const bool right_is_inside = is_inside(scene, right, reach);
  const bool is_wanted_inside = inflow.flows == InflowSide::left ? left_is_inside
                                : inflow.flows == InflowSide::right
                                    ? right_is_inside
                                    : left_is_inside || right_is_inside;
  if (!is_wanted_inside)
    throw CaseError(
        key + ".line",
        fmt::format("the ground up to {:.3g} m in front of it lies outside the DEM", reach),
        "draw it where the DEM has data on the side that it flows to");
  if (inflow.flows == InflowSide::left) return left;
  if (inflow.flows == InflowSide::right) return right;
  if (left_is_inside != right_is_inside) return left_is_inside ? left : right;
  if (std::abs(left.fall() - right.fall()) < level_slope)
    throw CaseError(key + ".flows", "the ground does not fall to either side of the line",
                    "give \"left\" or \"right\", looking from its first vertex to its last");
  return left.fall() > right.fall() ? left : right;
}

/// The line must reach up its banks.
void check_ends(const Scene& scene, const InflowPlan& plan, const std::string& key) {
  const double level = plan.highest_flow().level;
  const std::vector<Vec3d>& vertices = plan.line.vertices;
  const Vec3d ends[] = {vertices.front(), vertices.back()};
  const Vec3d chord = vertices.back() - vertices.front();
  const Vec3d outwards = (plan.spacing / std::hypot(chord.x, chord.y)) * chord;
  for (const int k : {0, 1}) {
    const double excess = level - plan.section.bed_at_ends()[k];
    if (!(excess > 0)) continue;
    Vec3d beside = ends[k] + (k == 0 ? -1.0 : 1.0) * outwards;
    beside.z = level - std::min(excess, plan.spacing) / 2;
    if (scene.is_solid(beside)) continue;
    throw CaseError(
        key + ".line",
        fmt::format("the highest level of {:.2f} m stands {:.2f} m above the ground at the line's "
                    "{} end: the flow would stand beyond it",
                    level, excess, k == 0 ? "first" : "last"),
        "widen the line up to the banks, give a higher speed, or check the discharge");
  }
}

void check_solids(const Scene& scene, const InflowPlan& plan, const std::string& key) {
  const double level = plan.highest_flow().level;
  for (const Vec3d& column : plan.section.columns()) {
    if (!(column.z < level)) continue;
    for (double beyond = 0; beyond <= plan.reach; beyond += plan.spacing) {
      Vec3d place = column + beyond * plan.section.direction();
      place.z = plan.section.bed(place) + plan.spacing / 2;
      if (scene.is_solid(place))
        throw CaseError(key + ".line",
                        fmt::format("a structure or body stands in the first {:.3g} m of the "
                                    "inflow",
                                    plan.reach),
                        "draw the line further upstream, or move what stands there");
    }
  }
}

InflowPlan plan_of(const InflowCase& inflow, const Case& c, const Scene& scene,
                   const std::string& key) {
  const double spacing = c.numerics.spacing;
  // What is free needs driven neighbours in all of its kernel, when the next layer has yet to come.
  const double radius = flow_model(c.material, c.numerics, 1).kernel_radius();
  const double reach = (std::ceil(radius / spacing) + 1) * spacing;
  Polyline line = read_line(inflow.line, key + ".line", scene);
  InflowSection section = section_of(inflow, scene, line, spacing, reach, key);
  InflowPlan plan{
      inflow.name, std::move(line), std::move(section), discharge_of(inflow, key), inflow.froude,
      spacing,     reach,           c.material.density, c.numerics.gravity};
  if (plan.hydrograph.speed.empty() && !(plan.gravity > 0))
    throw CaseError(key + ".froude", "means nothing without gravity", "give a speed");
  check_ends(scene, plan, key);
  check_solids(scene, plan, key);
  return plan;
}

/// Where the inflow that brings most comes in: the centre of its highest flow, on the bed.
Vec3d place_of_largest(const std::vector<InflowPlan>& inflows) {
  const InflowPlan& largest = *std::ranges::max_element(
      inflows, {}, [](const InflowPlan& plan) { return plan.hydrograph.volume(); });
  const double level = largest.highest_flow().level;
  Vec3d sum;
  double weight = 0;
  for (const Vec3d& column : largest.section.columns()) {
    const double depth = std::max(0.0, level - column.z);
    sum += depth * column;
    weight += depth;
  }
  Vec3d place = (1 / weight) * sum;
  place.z = largest.section.bed(place);
  return place;
}

}  // namespace

bool read_inflows(const Case& c, Scene& scene, Faults& faults) {
  bool is_read = true;
  for (std::size_t k = 0; k < c.inflows.size(); ++k) {
    const std::string key = fmt::format("inflow[{}]", k + 1);
    is_read =
        collected(faults, [&] { scene.inflows.push_back(plan_of(c.inflows[k], c, scene, key)); }) &&
        is_read;
  }
  if (!scene.inflows.empty()) scene.release_centre = place_of_largest(scene.inflows);
  return is_read;
}

void check_inflow_places(const Scene& scene) {
  for (std::size_t k = 0; k < scene.inflows.size(); ++k) {
    const InflowPlan& plan = scene.inflows[k];
    const auto is_in_it = [&](const Vec3d& x) { return plan.section.holds(x, plan.reach); };
    const std::string key = fmt::format("inflow[{}].line", k + 1);
    if (std::ranges::any_of(scene.release.position, is_in_it))
      throw CaseError(
          key, fmt::format("the release lies in the first {:.3g} m of the inflow", plan.reach),
          "move the line or the release");
    for (const InflowPlan& other : scene.inflows)
      if (&other != &plan && std::ranges::any_of(other.section.columns(), is_in_it))
        throw CaseError(key,
                        fmt::format("the inflow \"{}\" comes in within its first {:.3g} m",
                                    other.name, plan.reach),
                        "draw the lines further apart");
  }
}

}  // namespace sabo
