#include "run/frames.hpp"

#include <cstdint>
#include <list>
#include <span>
#include <system_error>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "run/scene_structures.hpp"
#include "run/show_fluid.hpp"

namespace sabo {
namespace {

std::string title(const char* name, const char* unit) {
  return *unit ? std::string(name) + " [" + unit + "]" : std::string(name);
}

std::vector<float> flattened(const std::vector<Vec3d>& values) {
  std::vector<float> flat;
  flat.reserve(3 * values.size());
  for (const Vec3d& v : values) flat.insert(flat.end(), {float(v.x), float(v.y), float(v.z)});
  return flat;
}

/// A frame of a fluid, at which it looks, and numbers of that in single precision.
struct FluidFrame {
  FluidFrame(double time, const Vec3d& origin, const Particles& fluid);
  FluidFrame(const FluidFrame&) = delete;

  VtpFrame frame;
  std::vector<Vec3f> points;
  std::list<std::vector<float>> floats;
};

FluidFrame::FluidFrame(double time, const Vec3d& origin, const Particles& fluid) {
  frame.time = time;
  frame.origin = origin;
  points.reserve(fluid.size());
  for (const Vec3d& x : fluid.position) points.push_back({float(x.x), float(x.y), float(x.z)});
  frame.points = points;

  const auto add = [this](std::string name, int components, std::vector<float> values) {
    const std::span<const float> kept(floats.emplace_back(std::move(values)));
    frame.arrays.push_back({std::move(name), components, kept});
  };
  fluid.for_each_shown_field(
      [&](const char* field, const char* unit, const char*, const auto& values) {
        using Value = typename std::decay_t<decltype(values)>::value_type;
        if constexpr (std::is_same_v<Value, std::uint32_t>)
          frame.arrays.push_back({title(field, unit), 1, std::span<const std::uint32_t>(values)});
        else if constexpr (std::is_same_v<Value, double>)
          add(title(field, unit), 1, {values.begin(), values.end()});
        else if (&values != &fluid.position)
          add(title(field, unit), 3, flattened(values));
      });
}

}  // namespace

Frames::Frames(const Scene& scene, const RunFolder& folder, int threads)
    : folder_(folder.frames()),
      origin_(scene.frame.origin()),
      list_(folder.frames() / "flow.pvd"),
      threads_(threads) {
  write_surface_vtp(folder_ / "ground.vtp", scene.surface->elevation(), origin_);
  if (!scene.dams.empty() || !scene.bodies.empty()) write_bodies(scene);
}

/// The numbers are those of the boundary particles.
void Frames::write_bodies(const Scene& scene) const {
  TriangleMesh all;
  std::vector<float> numbers;
  float number = 0;
  const auto add = [&](const TriangleMesh& mesh) {
    append(all, mesh);
    numbers.resize(all.vertices.size(), ++number);
  };
  for (const CheckDam& dam : scene.dams) add(shown_mesh(dam, scene));
  for (const Body& body : scene.bodies) add(body.mesh());
  write_mesh_vtp(folder_ / "bodies.vtp", all, numbers, origin_);
}

std::filesystem::path Frames::file(std::size_t number) const {
  return folder_ / fmt::format("flow_{:05}.vtp", number);
}

void Frames::take_back() const {
  std::error_code error;
  for (std::size_t k = 0; k < count_; ++k)
    if (!std::filesystem::exists(file(k), error)) throw RunError(file(k).string() + " is missing");
  for (std::size_t k = count_; std::filesystem::remove(file(k), error); ++k) continue;
}

void Frames::write(double time, Backend& backend) {
  show_fluid(backend, writing_, [this, number = count_, time](const Particles& fluid) {
    write_particles_vtp(file(number), FluidFrame(time, origin_, fluid).frame, threads_);
    list_.add(time, file(number).filename().string());
  });
  ++count_;  // one that fails beside the steps leaves a gap in the numbers, not in the list
}

}  // namespace sabo
