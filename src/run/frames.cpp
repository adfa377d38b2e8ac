#include "run/frames.hpp"

#include <list>
#include <system_error>
#include <type_traits>

#include <fmt/format.h>

#include "base/error.hpp"
#include "run/scene_structures.hpp"

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

}  // namespace

Frames::Frames(const Scene& scene, const RunFolder& folder)
    : folder_(folder.frames()),
      origin_{scene.frame.origin_x, scene.frame.origin_y, 0},
      list_(folder.frames() / "flow.pvd") {
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
  VtpFrame frame{time, origin_};
  std::vector<Vec3f> points;
  points.reserve(fluid.size());
  for (const Vec3d& x : fluid.position) points.push_back({float(x.x), float(x.y), float(x.z)});
  frame.points = points;

  std::list<std::vector<float>> kept;  // the frame holds views of these
  fluid.for_each_shown_field(
      [&](const char* field, const char* unit, const char*, const auto& values) {
        using Value = typename std::decay_t<decltype(values)>::value_type;
        if constexpr (std::is_same_v<Value, std::uint32_t>) {
          frame.arrays.push_back({title(field, unit), 1, std::span(values)});
        } else if constexpr (std::is_same_v<Value, double>) {
          kept.emplace_back(values.begin(), values.end());
          frame.arrays.push_back({title(field, unit), 1, std::span<const float>(kept.back())});
        } else if (&values != &fluid.position) {
          kept.push_back(flattened(values));
          frame.arrays.push_back({title(field, unit), 3, std::span<const float>(kept.back())});
        }
      });
  write_particles_vtp(file(count_), frame);
  list_.add(time, file(count_).filename().string());
  ++count_;
}

}  // namespace sabo
