#include "post/run_plan.hpp"

#include "run/overlay.hpp"

namespace sabo {
namespace {

/// The scene's frame is the CRS minus a whole-number origin.
Vec3d back(const Frame& frame, const Vec3d& x) { return x + frame.origin(); }

void move_back(const Frame& frame, std::vector<Vec3d>& vertices) {
  for (Vec3d& vertex : vertices) vertex = back(frame, vertex);
}

void move_back(const Frame& frame, std::vector<MapLine>& lines) {
  for (MapLine& line : lines) move_back(frame, line.line.vertices);
}

std::vector<MapLine> structures_of(const Scene& scene) {
  std::vector<MapLine> lines;
  for (const CheckDam& dam : scene.dams) lines.push_back({MapLine::Kind::dam, dam.name, dam.axis});
  for (std::size_t k = 0; k < scene.bodies.size(); ++k)
    add_outlines(MapLine::Kind::dam, scene.bodies[k].name(), "", {outline_of_body(scene, k)},
                 lines);
  return lines;
}

}  // namespace

RunPlan plan_of(const FinishedRun& run) {
  RunPlan plan;
  plan.problem = run.case_problem();
  if (!plan.problem.empty()) return plan;
  Faults faults;
  Scene scene = make_scene(run.run_case(), faults);
  if (!faults.empty()) {
    plan.problem = to_string(faults.list().front());
    return plan;
  }
  plan.lines = overlay(scene);
  plan.structures = structures_of(scene);
  for (const InflowPlan& inflow : scene.inflows)
    plan.inflows.push_back({MapLine::Kind::inflow, inflow.name, inflow.line});
  plan.zones = std::move(scene.zones);
  plan.sections = std::move(scene.sections);
  plan.path = std::move(scene.path);
  for (std::vector<MapLine>* lines : {&plan.lines, &plan.structures, &plan.inflows})
    move_back(scene.frame, *lines);
  for (NamedZone& zone : plan.zones)
    for (Polygon& polygon : zone.polygons)
      for (std::vector<Vec3d>& ring : polygon.rings) move_back(scene.frame, ring);
  for (NamedSection& section : plan.sections) move_back(scene.frame, section.line.vertices);
  move_back(scene.frame, plan.path.vertices);
  return plan;
}

}  // namespace sabo
