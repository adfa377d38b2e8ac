#include "run/frames.hpp"

#include <cstdint>
#include <list>
#include <memory>
#include <span>
#include <system_error>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "run/scene_structures.hpp"

namespace sabo {
namespace {

std::string title(const char* name, const char* unit) {
  return *unit ? std::string(name) + " [" + unit + "]" : std::string(name);
}

/// A frame and what it looks at.
struct OwnedFrame {
  VtpFrame frame;
  std::vector<Vec3f> points;
  std::list<std::vector<float>> floats;
  std::list<std::vector<std::uint32_t>> numbers;
};

std::vector<float> flattened(const std::vector<Vec3d>& values) {
  std::vector<float> flat;
  flat.reserve(3 * values.size());
  for (const Vec3d& v : values) flat.insert(flat.end(), {float(v.x), float(v.y), float(v.z)});
  return flat;
}

std::shared_ptr<const OwnedFrame> owned_frame(double time, const Vec3d& origin,
                                              const Particles& fluid) {
  const auto owned = std::make_shared<OwnedFrame>();
  VtpFrame& frame = owned->frame;
  frame.time = time;
  frame.origin = origin;
  owned->points.reserve(fluid.size());
  for (const Vec3d& x : fluid.position)
    owned->points.push_back({float(x.x), float(x.y), float(x.z)});
  frame.points = owned->points;

  const auto add = [&](std::string name, int components, std::vector<float> values) {
    owned->floats.push_back(std::move(values));
    const std::span<const float> kept(owned->floats.back());
    frame.arrays.push_back({std::move(name), components, kept});
  };
  fluid.for_each_shown_field(
      [&](const char* field, const char* unit, const char*, const auto& values) {
        using Value = typename std::decay_t<decltype(values)>::value_type;
        if constexpr (std::is_same_v<Value, std::uint32_t>) {
          owned->numbers.push_back(values);
          const std::span<const std::uint32_t> kept(owned->numbers.back());
          frame.arrays.push_back({title(field, unit), 1, kept});
        } else if constexpr (std::is_same_v<Value, double>) {
          add(title(field, unit), 1, {values.begin(), values.end()});
        } else if (&values != &fluid.position) {
          add(title(field, unit), 3, flattened(values));
        }
      });
  return owned;
}

}  // namespace

Frames::Frames(const Scene& scene, const RunFolder& folder, int threads, bool are_beside_steps)
    : folder_(folder.frames()),
      origin_(scene.frame.origin()),
      list_(folder.frames() / "flow.pvd"),
      threads_(threads),
      are_beside_steps_(are_beside_steps) {
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

void Frames::write(double time, const Particles& fluid) {
  const auto owned = owned_frame(time, origin_, fluid);
  const auto write = [this, owned, number = count_] {
    write_particles_vtp(file(number), owned->frame, threads_);
    list_.add(owned->frame.time, file(number).filename().string());
  };
  if (are_beside_steps_)
    writing_.start(write);  // one that fails leaves a gap in the numbers, not in the list
  else
    write();
  ++count_;
}

}  // namespace sabo
