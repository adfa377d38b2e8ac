#include "run/read_frames.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/case_file/read_case.hpp"

namespace sabo {
namespace {

namespace fs = std::filesystem;

const ParticleArray& array_of(const ParticleFrame& frame, const char* name, std::size_t components,
                              const fs::path& file) {
  const ParticleArray* array = frame.find(name);
  if (!array || array->values.size() != components * frame.points.size()) {
    throw CaseError(file.string(), fmt::format("has no sound array \"{}\"", name),
                    "run the case again with this version of sabo");
  }
  return *array;
}

void refuse_unless_run(const fs::path& run_folder) {
  if (fs::exists(run_folder / "manifest.toml")) return;
  throw CaseError(run_folder.string(), "is not the folder of a run: it has no manifest.toml",
                  "give a folder that `sabo run` has written");
}

}  // namespace

std::vector<PvdEntry> frames_of(const fs::path& run_folder) {
  refuse_unless_run(run_folder);
  std::vector<PvdEntry> frames = read_pvd(run_folder / "frames" / "flow.pvd");
  if (frames.empty()) throw CaseError(run_folder.string(), "has no frames", "run the case again");
  return frames;
}

Particles particles_of(const fs::path& file, const Frame& frame) {
  const ParticleFrame read = read_particles_vtp(file);
  const auto& velocity = array_of(read, "velocity [m/s]", 3, file).values;
  const auto& pressure = array_of(read, "pressure [Pa]", 1, file).values;
  const auto& mass = array_of(read, "mass [kg]", 1, file).values;
  const auto& id = array_of(read, "id", 1, file).values;
  const Vec3d shift = read.origin - frame.origin();
  Particles particles;
  particles.resize(read.points.size());
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const Vec3f& x = read.points[i];
    particles.position[i] = shift + Vec3d{x.x, x.y, x.z};
    particles.velocity[i] = {velocity[3 * i], velocity[3 * i + 1], velocity[3 * i + 2]};
    particles.pressure[i] = pressure[i];
    particles.mass[i] = mass[i];
    particles.id[i] = static_cast<std::uint32_t>(id[i]);
  }
  return particles;
}

void for_each_frame(const fs::path& run_folder, const Case& c, const Scene& scene,
                    const std::function<void(const RunFrame&)>& visit) {
  const std::vector<PvdEntry> frames = frames_of(run_folder);
  Columns columns(scene.surface->elevation(), c.numerics.spacing, c.material.density);
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const Particles particles = particles_of(run_folder / "frames" / frames[k].file, scene.frame);
    columns.update(particles);
    visit({k, frames[k].time, particles, columns});
  }
}

FinishedScene scene_of_run(const fs::path& run_folder) {
  refuse_unless_run(run_folder);
  Faults faults;
  FinishedScene finished;
  finished.run_case = read_case(run_folder, faults);
  faults.throw_if_any();
  finished.scene = make_scene(finished.run_case, faults);
  faults.throw_if_any();
  return finished;
}

}  // namespace sabo
