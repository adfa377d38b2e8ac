#include "run/preview_structures.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include <fmt/format.h>

#include "run/amount_text.hpp"
#include "run/dam_fillings.hpp"
#include "run/dam_openings.hpp"
#include "run/scene_structures.hpp"
#include "terrain/body_points.hpp"

namespace sabo {
namespace {

/// Crest and ground along a dam.
struct DamProfile {
  double lowest_crest = std::numeric_limits<double>::infinity();
  double highest_crest = -std::numeric_limits<double>::infinity();
  double greatest_height = 0;  ///< of the crest above the ground
};

DamProfile profile_of(const CheckDam& dam, const Surface& surface) {
  constexpr int samples = 200;
  DamProfile profile;
  const double end = length(dam.axis);
  for (int k = 0; k <= samples; ++k) {
    const double station = end * k / samples;
    const Vec3d place = point_at(dam.axis, station);
    const double crest = dam.top(station) + dam.notch_depth(station);
    profile.lowest_crest = std::min(profile.lowest_crest, crest);
    profile.highest_crest = std::max(profile.highest_crest, crest);
    profile.greatest_height =
        std::max(profile.greatest_height, crest - surface.height(place.x, place.y));
  }
  return profile;
}

std::string sill_text(const SillCase& sill) {
  if (sill.elevation) return fmt::format("from {:.2f} m", *sill.elevation);
  if (sill.height && *sill.height > 0)
    return fmt::format("from {:g} m above the ground", *sill.height);
  return "from the ground";
}

void tell_openings(Preview& preview, const StructureCase& c) {
  if (c.notch) {
    preview.line("Structures", fmt::format("  notch {:g} m wide and {:g} m deep at {:.1f} m",
                                           c.notch->width, c.notch->depth, c.notch->centre));
  }
  for (const SlitCase& slit : c.slits) {
    const std::string top =
        slit.height ? fmt::format("{:g} m high", *slit.height) : "open to the crest";
    preview.line("Structures", fmt::format("  slit {:g} m wide at {:.1f} m, {}, {}", slit.width,
                                           slit.centre, sill_text(slit.sill), top));
  }
  for (const GridCase& grid : c.grids) {
    const GridLayout layout = grid_layout(grid);
    const std::string beams =
        grid.beam_gap && grid.beam_height
            ? fmt::format(", beams {:g} m high, {:g} m apart", *grid.beam_height, *grid.beam_gap)
            : "";
    preview.line("Structures",
                 fmt::format("  grid of {} gaps of {:g} m, posts {:g} m wide, from {:.2f} to "
                             "{:.2f} m, {}{}",
                             layout.gaps, grid.gap, grid.post_width, layout.first,
                             layout.from(layout.gaps - 1) + grid.gap, sill_text(grid.sill), beams));
  }
}

/// Openings of few particles, and posts and beams of less than one.
void warn_of_openings(Preview& preview, const StructureCase& c, double spacing) {
  for (const ClearWidth& clear : clear_widths(c)) {
    if (clear.width >= enough_across * spacing * (1 - 1e-9)) continue;
    preview.warn(
        fmt::format("\"{}\": {} = {:g} m is only {:.1f} particles; what passes is too "
                    "little until numerics.spacing is {:.2g} m or less, for {:g}",
                    c.name, clear.key, clear.width, clear.width / spacing,
                    clear.width / enough_across, enough_across));
  }
  for (const GridCase& grid : c.grids) {
    const double thinnest = std::min({grid.post_width, grid.post_depth.value_or(grid.post_width),
                                      grid.beam_height.value_or(grid.post_width)});
    if (thinnest >= spacing * (1 - 1e-9)) continue;
    preview.warn(
        fmt::format("\"{}\": its posts or beams are {:g} m thin, less than one particle: "
                    "they hold back too little until numerics.spacing is {:.2g} m or less",
                    c.name, thinnest, thinnest));
  }
}

/// What a check dam can hold.
void tell_basin(Preview& preview, const CheckDam& dam, const Scene& scene) {
  const Basin basin = basin_behind(dam, scene);
  if (basin.capacity() <= 0) return;
  preview.line(
      "Structures",
      fmt::format("  holds {} m3 below a level pool at {:.2f} m, {:.2f} m above its foot",
                  amount_text(basin.capacity()), basin.level(), basin.level() - basin.foot()));
  if (basin.is_flanked())
    preview.warn(
        fmt::format("a pool behind \"{}\" leaves at {:.2f} m by the ground beside it, "
                    "below its top: lengthen its line, or expect the flow to pass there",
                    dam.name, basin.level()));
}

void tell_dam(Preview& preview, const StructureCase& c, const CheckDam& dam, const Scene& scene,
              const FlowModel& model) {
  const DamProfile profile = profile_of(dam, *scene.surface);
  const bool is_level = profile.highest_crest - profile.lowest_crest < 0.005;
  const std::string crest =
      is_level ? fmt::format("{:.2f}", profile.highest_crest)
               : fmt::format("{:.2f} to {:.2f}", profile.lowest_crest, profile.highest_crest);
  preview.line(
      "Structures",
      fmt::format("{}: {:.1f} m long, {:g} m thick, crest at {} m, up to {:.2f} m above "
                  "the ground",
                  dam.name, length(dam.axis), dam.thickness, crest, profile.greatest_height));
  if (c.kind == StructureKind::check_dam) tell_basin(preview, dam, scene);
  tell_openings(preview, c);
  warn_of_openings(preview, c, model.spacing);
  // The nearest particles stand half a spacing from either face.
  const double thinnest = model.kernel_radius() - model.spacing;
  if (dam.thickness < thinnest) {
    preview.warn(fmt::format(
        "\"{}\" is {:g} m thick: the flow on one side feels that on the other through it below "
        "{:.2f} m; take a smaller numerics.spacing",
        dam.name, dam.thickness, thinnest));
  }
}

/// Of one structure with buildings.
void tell_buildings(Preview& preview, const StructureCase& c, const Scene& scene) {
  std::size_t count = 0;
  double ground = 0, lowest = std::numeric_limits<double>::infinity(), highest = 0;
  for (const Building& building : scene.buildings) {
    if (building.group != c.name) continue;
    ++count;
    ground += area(building.outline);
    lowest = std::min(lowest, building.top - building.bottom);
    highest = std::max(highest, building.top - building.bottom);
  }
  const std::string height = highest - lowest < 0.005
                                 ? fmt::format("{:.2f}", highest)
                                 : fmt::format("{:.2f} to {:.2f}", lowest, highest);
  preview.line("Structures",
               fmt::format("{}: {} over {:.1f} m2, {} m above the lowest ground of {}", c.name,
                           count == 1 ? "a building" : fmt::format("{} buildings", count), ground,
                           height, count == 1 ? "its outline" : "each outline"));
}

void tell_body(Preview& preview, const BodyCase& c, const Body& body, const FlowModel& model) {
  const std::size_t particles = body_points(body, model.spacing, model.state.rho0).size();
  const Bounds bounds = bounds_of(body.mesh());
  preview.line("Bodies", fmt::format("{}: {}, {} of {:.4g} m3 and {:.4g} m2, {} triangles, "
                                     "watertight, {} particles",
                                     body.name(), word_of(c.kind),
                                     body.flow() == FlowSide::inside ? "a hollow" : "a solid",
                                     volume(body.mesh()), area(body.mesh()),
                                     body.mesh().triangles.size(), particles));
  if (c.kind != BodyKind::mesh) return;
  const Vec3d size = bounds.size();
  preview.line("Bodies", fmt::format("  {:.4g} x {:.4g} x {:.4g} m, from {:.4g} to {:.4g} m high",
                                     size.x, size.y, size.z, bounds.low.z, bounds.high.z));
}

}  // namespace

void tell_structures(Preview& preview, const Case& c, const Scene& scene, const FlowModel& model) {
  std::size_t dam = 0;  // in the order of the scene: check dams first
  for (const StructureKind kind : {StructureKind::check_dam, StructureKind::deflection_wall}) {
    for (const StructureCase& structure : c.structures)
      if (structure.kind == kind) tell_dam(preview, structure, scene.dams[dam++], scene, model);
  }
  for (const StructureCase& structure : c.structures)
    if (structure.kind == StructureKind::building) tell_buildings(preview, structure, scene);
  for (std::size_t k = 0; k < c.bodies.size(); ++k)
    tell_body(preview, c.bodies[k], scene.bodies[k], model);
}

}  // namespace sabo
