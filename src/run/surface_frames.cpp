#include "run/surface_frames.hpp"

#include <vector>

#include <fmt/format.h>

#include "analysis/flow_surface.hpp"

namespace sabo {

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
  write_moving_surface_vtp(folder_ / name,
                           {.time = frame.time,
                            .origin = {scene_.frame.origin_x, scene_.frame.origin_y, 0},
                            .mesh = surface.mesh,
                            .arrays = {{"depth [m]", 1, std::span(depth)},
                                       {"speed [m/s]", 1, std::span(speed)},
                                       {"ground [m]", 1, std::span(ground)}}});
  list_.add(frame.time, name);
}

}  // namespace sabo
