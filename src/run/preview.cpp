#include "run/preview.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "analysis/resolution.hpp"
#include "analysis/zone.hpp"
#include "base/counted.hpp"
#include "case/material_presets.hpp"
#include "io/gis/crs.hpp"
#include "io/gis/gdal_errors.hpp"
#include "math/angle.hpp"
#include "physics/shear_state.hpp"
#include "physics/viscosity_of_concentration.hpp"
#include "run/amount_text.hpp"
#include "run/memory_estimate.hpp"
#include "run/preview_card.hpp"
#include "run/preview_inflows.hpp"
#include "run/preview_lines.hpp"
#include "run/preview_structures.hpp"
#include "solver/flow_model.hpp"
#include "solver/make_backend.hpp"

namespace sabo {
namespace {

double degrees_of(double slope) { return std::atan(slope) / degree; }

/// A number of which the first digits matter: "870", "287 thousand", "3.4 million".
std::string count_text(double count) {
  if (count < 1e4) return fmt::format("{:.0f}", count);
  if (count < 1e6) return fmt::format("{:.0f} thousand", count / 1e3);
  return fmt::format("{:.1f} million", count / 1e6);
}

void tell_terrain(Preview& preview, const Scene& scene) {
  const Raster& ground = scene.surface->elevation();
  const Grid& grid = ground.grid;
  const GdalErrors errors;
  const std::string crs =
      scene.frame.crs.empty() ? "no coordinate system" : name_of(crs_of(scene.frame.crs));
  preview.line("Terrain", fmt::format("{} x {} cells of {:g} x {:g} m, {}", grid.columns, grid.rows,
                                      grid.dx, grid.dy, crs));
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -lowest;
  for (const double z : ground.values) {
    if (std::isnan(z)) continue;
    lowest = std::min(lowest, z);
    highest = std::max(highest, z);
  }
  preview.line("Terrain", fmt::format("elevation {:.1f} to {:.1f} m", lowest, highest));

  for (const std::string& note : scene.dem_notes) preview.line("Terrain", note);
  const HoleReport& holes = scene.holes;
  if (holes.holes_filled > 0) {
    preview.line("Terrain", fmt::format("{} filled, with {}", counted(holes.holes_filled, "hole"),
                                        counted(holes.cells_filled, "cell")));
  }
  if (holes.border_cells_left > 0) {
    preview.line("Terrain",
                 counted(holes.border_cells_left, "cell") + " without data at the border");
  }
  if (holes.holes_left > 0) {
    preview.warn(fmt::format(
        "too large to fill (terrain.fill_holes): {} of the DEM with {}; what flows there leaves "
        "the domain",
        counted(holes.holes_left, "hole"), counted(holes.enclosed_cells_left, "cell")));
  }
}

void tell_edits(Preview& preview, const Scene& scene) {
  for (const MadeEdit& edit : scene.edits) {
    const EditReport& report = edit.report;
    preview.line("Edits", fmt::format("{}: {}, {:.0f} m3 cut, {:.0f} m3 filled, by up to {:.2f} m",
                                      report.name, counted(report.cells, "cell"), report.cut,
                                      report.fill, report.greatest));
  }
  if (scene.lost) {
    preview.line("Edits", fmt::format("the ground under the release is lowered to dem_after: "
                                      "{:.0f} m3",
                                      scene.lost->dug));
  }
}

/// Slope of the ground under the release, m/m: mean over its mass.
double release_slope(const Scene& scene) {
  double slope = 0;
  for (const Vec3d& x : scene.release.position) {
    const Vec3d normal = scene.surface->normal(x.x, x.y);
    slope += std::hypot(normal.x, normal.y) / normal.z;
  }
  return slope / static_cast<double>(scene.release.size());
}

void tell_release(Preview& preview, const Case& c, const Scene& scene) {
  const double dp = c.numerics.spacing;
  const double layers = scene.release_depth / dp;
  preview.line("Release",
               fmt::format("{} m3, up to {} m deep, centre at ({:.1f}, {:.1f})",
                           amount_text(scene.release_volume), amount_text(scene.release_depth),
                           scene.frame.origin_x + scene.release_centre.x,
                           scene.frame.origin_y + scene.release_centre.y));
  preview.line("Release", fmt::format("on a slope of {:.1f} deg in the mean",
                                      degrees_of(release_slope(scene))));
  preview.line("Release", fmt::format("{} particles at {:g} m: {:.1f} in the greatest depth",
                                      scene.release.size(), dp, layers));
  if (scene.release_left_out > 0) {
    preview.warn(fmt::format("{} m3 of the release would stand inside structures and are left out",
                             amount_text(scene.release_left_out)));
  }
  if (layers < ResolutionGuard::enough_layers) {
    preview.warn(
        fmt::format("the release is only {:.1f} particles deep; take numerics.spacing = {:.2g} m "
                    "or less for {:g}",
                    layers, scene.release_depth / ResolutionGuard::enough_layers,
                    ResolutionGuard::enough_layers));
  }
}

void tell_lines(Preview& preview, const Case& c, const Scene& scene) {
  for (const NamedSection& section : scene.sections) {
    preview.line("Sections", fmt::format("{}: {:.1f} m long", section.name, length(section.line)));
  }
  for (std::size_t k = 0; k < scene.zones.size(); ++k) {
    const double area = Zone(scene.surface->elevation(), scene.zones[k].polygons).area();
    preview.line("Zones", fmt::format("{}: {} m2", scene.zones[k].name, amount_text(area)));
  }
  const double run = length(scene.path);
  if (!(run > 0)) return;
  const Vec3d& first = scene.path.vertices.front();
  const Vec3d& last = scene.path.vertices.back();
  const double fall =
      scene.surface->height(first.x, first.y) - scene.surface->height(last.x, last.y);
  preview.line("Path", fmt::format("{} m long, falls {} m, mean slope {:.1f} deg ({})",
                                   amount_text(run), amount_text(fall), degrees_of(fall / run),
                                   scene.path_is_descent ? "found by steepest descent" : "given"));
  const MohrCoulomb& yield = c.material.yield;
  if (!has_yield(c.material.law) || fall / run >= yield.slope()) return;
  preview.warn(fmt::format(
      "the path's mean slope of {:.1f} deg is below the effective friction angle of {:.1f} deg "
      "(friction_angle {:g} deg, pore_pressure_ratio {:g}): the mass may not reach its end",
      degrees_of(fall / run), degrees_of(yield.slope()), yield.friction_angle,
      yield.pore_pressure_ratio));
}

/// Where the numbers of the material are from, and why not to trust them blindly.
void tell_sources(Preview& preview, const MaterialCase& material) {
  if (const MaterialPreset* preset = find_preset(material.preset.name)) {
    preview.line("Material", fmt::format("preset {}: {}", preset->name, preset->source));
    preview.warn(fmt::format("preset {}: {}", preset->name, preset->caution));
  }
  if (material.concentration) {
    preview.warn(fmt::format(
        "the viscosity of {:.4g} Pa s is 0.621 exp(0.173 x {:g}), in whose source the unit is "
        "probably mPa s: compare with flows whose speed you know",
        viscosity_of_concentration(*material.concentration), *material.concentration));
  }
}

void tell_fast_step(Preview& preview, const Case& c, const FlowModel& model) {
  const double slow = c.numerics.cfl * model.h / model.state.c0;
  const double speed = c.numerics.reference_speed;
  const double fast = c.numerics.cfl * model.h / (model.state.c0 + speed);
  preview.line(
      "Numerics",
      speed > 0 ? fmt::format("time step {:.3g} s at rest, {:.3g} s at {:g} m/s", slow, fast, speed)
                : fmt::format("time step {:.3g} s at rest, shorter in fast flow", slow));
}

void tell_paper_step(Preview& preview, const Case& c, const FlowModel& model) {
  const TimeStepRule rule = time_step_rule(c.numerics, model);
  const double speed = c.numerics.reference_speed;
  const double stiffest =
      std::visit([](const auto& law) { return law.max_viscosity(); }, c.material.law);
  const double viscosity = stiffest / c.material.density;
  const TimeStep without_viscosity = rule({speed, c.numerics.gravity, 0});
  const TimeStep step = rule({speed, c.numerics.gravity, viscosity});
  preview.line("Numerics",
               fmt::format("time step {:.3g} s, {} limit{}", step.dt, word_of(step.limit),
                           step.limit == StepLimit::viscous
                               ? fmt::format(" while at rest ({:.3g} s without viscosity)",
                                             without_viscosity.dt)
                               : ""));
  preview.line("Numerics",
               fmt::format("about {} steps for {:g} s",
                           count_text(std::ceil(c.run.duration / step.dt)), c.run.duration));
}

/// A fluid carries no more of the friction of the ground than its viscosity does over half a
/// spacing: a thin one hardly feels it.
void warn_of_a_weak_wall(Preview& preview, const Case& c, const FlowModel& model, double depth) {
  if (c.numerics.wall != WallLaw::coulomb && c.numerics.wall != WallLaw::voellmy) return;
  const double g = c.numerics.gravity, density = c.material.density;
  const double speed = std::sqrt(2 * g * depth), rate = speed / (model.spacing / 2);
  const double pressure = density * g * depth;
  const WallContact at{speed, model.yield.effective_pressure(pressure), density, g,
                       std::numeric_limits<double>::infinity()};
  const double asked =
      speed * std::visit([&](const auto& wall) { return wall.resistance(at); }, model.wall);
  const auto carried = [&]<class Law>(const Law& law) {
    return rate * law.viscosity(shear_state<Law>(rate, pressure, model.yield, model.yield.slope()));
  };
  const double most = std::visit(carried, model.rheology);
  if (most >= asked / 2) return;
  preview.warn(fmt::format(
      "wall = \"{}\" asks for {:.2g} kPa under {:.2g} m of flow at {:.2g} m/s; this material "
      "carries {:.2g} kPa of it at this spacing (docs/method.md): it will run too far",
      word_of(c.numerics.wall), asked / 1e3, depth, speed, most / 1e3));
}

void tell_numerics(Preview& preview, const Case& c, const FlowModel& model, double depth) {
  const double stiffest =
      std::visit([](const auto& law) { return law.max_viscosity(); }, c.material.law);
  preview.line("Material", fmt::format("{}, {:g} kg/m3, at most {:.3g} Pa s",
                                       name_of(c.material.law), c.material.density, stiffest));
  tell_sources(preview, c.material);
  preview.line("Numerics", fmt::format("{}, h = {:g} m, sound speed {:.0f} m/s",
                                       word_of(c.numerics.method), model.h, model.state.c0));
  if (c.numerics.method == Method::fast)
    tell_fast_step(preview, c, model);
  else
    tell_paper_step(preview, c, model);
  warn_of_a_weak_wall(preview, c, model, depth);
}

void tell_memory(Preview& preview, const Case& c, const FlowModel& model, std::size_t particles,
                 std::size_t dem_cells) {
  const bool is_on_card = c.numerics.backend == BackendKind::cuda;
  const double of_host = is_on_card
                             ? expected_memory_beside_card(model, particles, dem_cells)
                             : expected_memory(model, c.numerics.method, particles, dem_cells);
  preview.line("Memory",
               fmt::format("about {:.0f} MB{}", of_host / 1e6, is_on_card ? " of the host" : ""));
  if (!is_on_card) return;
  const double of_card = expected_card_memory(model, c.numerics.method, particles);
  if (const std::string fault = missing_backend(BackendKind::cuda); !fault.empty())
    tell_missing_card(preview, of_card, fault);
  else
    tell_card_memory(preview, of_card, graphics_card());
}

}  // namespace

std::string preview_text(const Case& c, const Scene& scene, const std::string& time) {
  const FlowModel model = flow_model(c.material, c.numerics, scene.greatest_depth());
  const std::size_t particles = scene.particles_until(c.run.duration);
  Preview preview;
  if (!c.title.empty()) preview.line("Case", c.title);
  if (!c.note.empty()) preview.line("Case", c.note);
  tell_terrain(preview, scene);
  tell_edits(preview, scene);
  if (scene.release.size() > 0) tell_release(preview, c, scene);
  tell_inflows(preview, c, scene);
  preview.line("Particles",
               fmt::format("{} of the flow; the ground near it takes up to about {}", particles,
                           count_text(expected_boundary(model, particles))));
  tell_structures(preview, c, scene, model);
  tell_lines(preview, c, scene);
  tell_numerics(preview, c, model, scene.greatest_depth());
  tell_memory(preview, c, model, particles, scene.surface->elevation().grid.size());
  if (!time.empty()) preview.line("Time", time);
  return preview.text();
}

}  // namespace sabo
