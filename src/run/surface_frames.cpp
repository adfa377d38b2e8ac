#include "run/surface_frames.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "analysis/flow_surface.hpp"
#include "io/output/file.hpp"

namespace sabo {
namespace {

Bounds united(const Bounds& a, const Bounds& b) {
  return {
      {std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y), std::min(a.low.z, b.low.z)},
      {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y), std::max(a.high.z, b.high.z)}};
}

}  // namespace

SurfaceFrames::SurfaceFrames(const std::filesystem::path& folder, const Scene& scene)
    : scene_(scene), folder_(folder), list_(folder / "surface.pvd") {}

void SurfaceFrames::write(const RunFrame& frame) {
  const FlowSurface surface = flow_surface(frame.columns, scene_.surface->elevation());
  const auto floats = [](const std::vector<double>& values) {
    return std::vector<float>(values.begin(), values.end());
  };
  const std::vector<float> depth = floats(surface.depth), speed = floats(surface.speed),
                           ground = floats(surface.ground);
  const std::string name = fmt::format("surface_{:05}.vtp", frame.number);
  write_moving_surface_vtp(folder_ / name, {.time = frame.time,
                                            .origin = scene_.frame.origin(),
                                            .mesh = surface.mesh,
                                            .arrays = {{"depth [m]", 1, std::span(depth)},
                                                       {"speed [m/s]", 1, std::span(speed)},
                                                       {"ground [m]", 1, std::span(ground)}}});
  list_.add(frame.time, name);
  shown_.end = frame.time;
  if (!surface.mesh.vertices.empty()) {
    const Bounds bounds = bounds_of(surface.mesh);
    shown_.flow = has_surface_ ? united(shown_.flow, bounds) : bounds;
    has_surface_ = true;
  }
  for (const double depth_there : surface.depth)
    shown_.deepest = std::max(shown_.deepest, depth_there);
}

void SurfaceFrames::finish() {
  shown_.folder = std::filesystem::absolute(folder_).lexically_normal();
  shown_.has_bodies = !scene_.dams.empty() || !scene_.bodies.empty();
  write_file_atomically(folder_ / "paraview.pvsm", paraview_state(shown_));
}

}  // namespace sabo
