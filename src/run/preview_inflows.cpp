#include "run/preview_inflows.hpp"

#include <cmath>
#include <numbers>
#include <string_view>

#include <fmt/format.h>

#include "analysis/resolution.hpp"
#include "math/angle.hpp"
#include "run/amount_text.hpp"
#include "run/scene_structures.hpp"

namespace sabo {
namespace {

/// "east" for [1, 0]: the nearest of eight.
std::string_view compass_word(const Vec3d& direction) {
  constexpr std::string_view words[] = {"east", "north-east", "north", "north-west",
                                        "west", "south-west", "south", "south-east"};
  const long eighth = std::lround(std::atan2(direction.y, direction.x) * 4 / std::numbers::pi);
  return words[(eighth + 8) % 8];
}

void warn_of(Preview& preview, const InflowPlan& inflow, const SectionFlow& peak, double duration) {
  const double layers = peak.depth / inflow.spacing;
  const double across = peak.width / inflow.spacing;
  if (layers < ResolutionGuard::enough_layers)
    preview.warn(fmt::format(
        "the inflow \"{}\" is only {:.1f} particles deep at its peak; take numerics.spacing = "
        "{:.2g} m or less for {:g}",
        inflow.name, layers, peak.depth / ResolutionGuard::enough_layers,
        ResolutionGuard::enough_layers));
  if (across < enough_across)
    preview.warn(
        fmt::format("the inflow \"{}\" is only {:.1f} particles wide at its peak; take "
                    "numerics.spacing = {:.2g} m or less for {:g}",
                    inflow.name, across, peak.width / enough_across, enough_across));
  if (!(inflow.section.fall() > 0))
    preview.warn(
        fmt::format("the ground rises in front of the inflow \"{}\", by {:.1f} deg in the "
                    "mean",
                    inflow.name, std::atan(-inflow.section.fall()) / degree));
  const double volume = inflow.hydrograph.volume();
  const double in_time = inflow.hydrograph.volume_until(duration);
  if (in_time < 0.999 * volume)
    preview.warn(fmt::format("the run ends before the inflow \"{}\" does: {} of {} m3 come in",
                             inflow.name, amount_text(in_time), amount_text(volume)));
}

}  // namespace

void tell_inflows(Preview& preview, const Case& c, const Scene& scene) {
  for (const InflowPlan& inflow : scene.inflows) {
    const Hydrograph& hydrograph = inflow.hydrograph;
    const std::size_t row = hydrograph.peak();
    const SectionFlow peak = inflow.flow_at_peak();
    preview.line("Inflow",
                 fmt::format("{}: {} m3 until {:g} s, at most {:.4g} m3/s at {:g} s, to the {} on "
                             "a slope of {:.1f} deg",
                             inflow.name, amount_text(hydrograph.volume()), hydrograph.end(),
                             hydrograph.discharge[row], hydrograph.time[row],
                             compass_word(inflow.section.direction()),
                             std::atan(inflow.section.fall()) / degree));
    preview.line("Inflow",
                 fmt::format("at its peak {:.2f} m deep, {:.1f} m wide, {:.1f} m2 at {:.1f} m/s; "
                             "level {:.2f} m",
                             peak.depth, peak.width, peak.area, peak.speed, peak.level));
    preview.line("Inflow",
                 fmt::format("{} particles come at {:g} m: {:.1f} in the depth of its peak",
                             inflow.particles_until(c.run.duration), inflow.spacing,
                             peak.depth / inflow.spacing));
    warn_of(preview, inflow, peak, c.run.duration);
  }
}

}  // namespace sabo
