#include "run/branch.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

#include <fmt/format.h>

#include "run/case_difference.hpp"
#include "run/flow.hpp"
#include "run/resume.hpp"
#include "solver/domain.hpp"
#include "solver/flow_model.hpp"

namespace sabo {
namespace {

// Each is a key, or the beginning of some. Particles keep their numbers, masses and frame.
constexpr std::array<std::string_view, 6> fixed_keys{"release.",         "numerics.spacing",
                                                     "material.density", "terrain.dem",
                                                     "terrain.cr",       "terrain.cell"};

FoundCheckpoint checkpoint_at(const BranchOrigin& origin, double tolerance,
                              const std::function<void(const std::string&)>& tell) {
  const std::vector<FoundCheckpoint> found =
      find_checkpoints(origin.run_folder / "checkpoint", tell);
  if (found.empty())
    throw CaseError(origin.run_folder.string(), "has no checkpoint that can be read",
                    "run its case anew with a run.checkpoint_interval above 0");
  for (const FoundCheckpoint& checkpoint : found)
    if (checkpoint.head.time <= origin.time + tolerance) return checkpoint;
  throw CaseError(origin.run_folder.string(),
                  fmt::format("has no checkpoint at or before {:g} s, the first one is at {:g} s",
                              origin.time, found.back().head.time),
                  "run its case anew with run.kept_checkpoint_interval, or with that time as its "
                  "duration");
}

void check_case(const Case& c, const Scene& scene, const FoundCheckpoint& checkpoint) {
  Faults faults;
  const Case before = case_of(checkpoint);
  if (!scene.inflows.empty() || !before.inflows.empty())
    faults.add("inflow", "a run with inflows cannot be branched",
               "run the changed case from its start");
  for (const KeyDifference& difference : case_differences(before, c)) {
    const auto is_in = [&](std::string_view key) { return difference.key.starts_with(key); };
    if (std::ranges::none_of(fixed_keys, is_in)) continue;
    faults.add(difference.key,
               fmt::format("is {} and was {} in the other run, whose particles are taken over",
                           difference.after.empty() ? "not given" : difference.after,
                           difference.before.empty() ? "not given" : difference.before),
               "set it back");
  }
  const Vec3d origin = scene.frame.origin();
  if (faults.empty() &&
      !(origin == checkpoint.head.origin && scene.release.size() == checkpoint.head.released))
    faults.add("release", "gives other particles than in the other run",
               "keep structures, bodies and edits of the ground out of the release");
  faults.throw_if_any();
  if (checkpoint.head.time >= c.run.duration)
    throw CaseError(
        "run.duration",
        fmt::format("the state that is taken over is at {:g} s already", checkpoint.head.time),
        "give a longer --duration");
}

/// Particles inside of one solid.
struct Buried {
  std::size_t count = 0;
  double mass = 0;  // kg
  Vec3d sum;        // of places, m
};

std::string holder_of(const Vec3d& place, const Scene& scene) {
  for (const CheckDam& dam : scene.dams)
    if (dam.contains(place)) return dam.name;
  for (const Body& body : scene.bodies)
    if (body.contains(place)) return body.name();
  return "the ground";
}

void check_room(const Case& c, const Scene& scene, const FlowModel& model,
                const BranchStart& start) {
  const Ground ground(*scene.surface, scene.dams, ground_settings(model), scene.bodies);
  std::map<std::string, Buried> buried;
  for (std::size_t i = 0; i < start.fluid.size(); ++i) {
    const Vec3d& x = start.fluid.position[i];
    if (!ground.surface().inside(x.x, x.y) || !ground.is_solid(x)) continue;
    if (norm(ground.pushed_out(x) - x) < Domain::tolerated_depth * ground.spacing()) continue;
    Buried& in = buried[holder_of(x, scene)];
    ++in.count;
    in.mass += start.fluid.mass[i];
    in.sum += x;
  }
  Faults faults;
  for (const auto& [name, in] : buried) {
    const Vec3d middle = (1.0 / static_cast<double>(in.count)) * in.sum;
    faults.add(
        name,
        fmt::format("would hold {} particles of the flow, {:.3g} m3, about x {:.1f} y {:.1f}",
                    in.count, in.mass / c.material.density, middle.x + scene.frame.origin_x,
                    middle.y + scene.frame.origin_y),
        fmt::format("put it where there is no flow at {:g} s, or branch earlier", start.time));
  }
  faults.throw_if_any();
}

}  // namespace

BranchStart branch_start(const Case& c, const Scene& scene, const BranchOrigin& origin,
                         const std::function<void(const std::string&)>& tell) {
  const FoundCheckpoint checkpoint = checkpoint_at(origin, c.run.series_interval, tell);
  check_case(c, scene, checkpoint);
  ArchivedFluid archived;
  read_state_file(checkpoint.file, checkpoint_version).read_head([&](ArchiveReader& a) {
    CheckpointHead head;
    a(head, archived);
  });
  BranchStart start{checkpoint.head.time, std::move(archived.particles)};
  // With another speed of sound pressures stay, as in Backend::set_sound_speed().
  const FlowModel model = flow_model(c.material, c.numerics, scene.release_depth);
  const Tait before{model.state.rho0, archived.sound_speed};
  if (before.c0 != model.state.c0)
    for (double& density : start.fluid.density)
      density = model.state.density(before.pressure(density));
  check_room(c, scene, model, start);
  tell(fmt::format("Starts from {:.6g} s of {}", start.time, checkpoint.file.string()));
  return start;
}

}  // namespace sabo
