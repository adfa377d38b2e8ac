#include "io/case_file/check_rules.hpp"

#include <cmath>

#include <fmt/format.h>

#include "io/case_file/check_bodies.hpp"
#include "io/case_file/check_inflows.hpp"
#include "io/case_file/check_observed.hpp"
#include "io/case_file/check_parts.hpp"
#include "io/case_file/check_structures.hpp"
#include "io/case_file/key_text.hpp"
#include "io/case_file/listing.hpp"
#include "physics/viscosity_of_concentration.hpp"

namespace sabo {
namespace {

void check_crop(const TerrainCase& terrain, Faults& faults) {
  if (!terrain.crop) return;
  const auto& [west, south, east, north] = *terrain.crop;
  if (!(west < east && south < north)) {
    faults.add("terrain.crop", "the window is empty", "give [west, south, east, north]");
  }
}

/// The ground is a DEM or a plane; what is said of how to read a DEM means nothing for a plane.
void check_ground(const TerrainCase& terrain, Faults& faults) {
  const bool has_dem = !terrain.dem.empty() || faults.has("terrain.dem");
  const bool has_plane = terrain.plane || faults.has("terrain.plane");
  if (has_dem == has_plane) {
    faults.add("terrain", has_dem ? "has a dem and a plane" : "has no ground",
               "give one of dem and plane");
  }
  if (!terrain.plane) return;
  const auto& [west, south, east, north] = terrain.plane->extent;
  if (!(west < east && south < north) && !faults.has("terrain.plane.extent")) {
    faults.add("terrain.plane.extent", "is empty", "give [west, south, east, north]");
  }
  const TerrainCase plain;
  const struct {
    const char* key;
    bool is_given;
  } keys[] = {{"assume_metres", terrain.assume_metres},
              {"crs", !terrain.crs.empty()},
              {"cell_size", terrain.cell_size.has_value()},
              {"crop", terrain.crop.has_value()},
              {"fill_holes", terrain.fill_holes != plain.fill_holes}};
  for (const auto& [name, is_given] : keys) {
    const std::string key = fmt::format("terrain.{}", name);
    if (is_given && !has_dem && !faults.has(key))
      faults.add(key, "applies to a dem only", "remove it");
  }
}

/// Each kind of edit has a key of its own and takes no other.
void check_edit(const TerrainEditCase& edit, const std::string& path, Faults& faults) {
  struct Rule {
    const char* key;
    bool is_given;
    bool is_wanted;
  };
  const bool shifts = edit.kind == TerrainEditKind::lower || edit.kind == TerrainEditKind::raise;
  const Rule rules[] = {
      {"elevation", edit.elevation.has_value(), edit.kind == TerrainEditKind::set},
      {"by", edit.by.has_value(), shifts},
      {"radius", edit.radius.has_value(), edit.kind == TerrainEditKind::smooth}};
  check_polygon(edit.polygon, path + ".polygon", faults);
  if (faults.has(path + ".kind")) return;
  for (const Rule& rule : rules) {
    const std::string key = fmt::format("{}.{}", path, rule.key);
    if (rule.is_given == rule.is_wanted || faults.has(key)) continue;
    faults.add(key,
               rule.is_wanted ? fmt::format("is missing for kind \"{}\"", word_of(edit.kind))
                              : fmt::format("does not apply to kind \"{}\"", word_of(edit.kind)),
               rule.is_wanted ? "give it, in m" : "remove it");
  }
}

/// The surfaces before and after an event come as a pair, which takes the place of a thickness.
void check_dem_pair(const ReleaseCase& release, Faults& faults) {
  const bool before = !release.dem_before.empty() || faults.has("release.dem_before");
  const bool after = !release.dem_after.empty() || faults.has("release.dem_after");
  if (before != after) {
    faults.add(before ? "release.dem_before" : "release.dem_after", "is one of a pair",
               before ? "give dem_after too" : "give dem_before too");
  }
  if (!before && !after && release.least_thickness != ReleaseCase{}.least_thickness) {
    faults.add("release.least_thickness", "applies to dem_before and dem_after only", "remove it");
  }
  if ((before || after) && release.normal) {
    faults.add("release.normal", "does not apply to a difference of elevations", "remove it");
  }
}

/// A polygon needs one of three things that give it a thickness, unless surfaces are compared in
/// it.
void check_polygon_thickness(const ReleaseCase& release, Faults& faults) {
  const bool thickness = release.thickness || faults.has("release.thickness");
  const bool attribute =
      !release.thickness_attribute.empty() || faults.has("release.thickness_attribute");
  const bool volume = release.volume || faults.has("release.volume");
  if (thickness + attribute > 1) {
    faults.add("release.thickness_attribute", "the polygon has a thickness too",
               "give one of the two");
  } else if (thickness && volume) {
    faults.add("release.polygon", "has a thickness and a volume", "give one of the two");
  } else if (!thickness && !attribute && !volume) {
    faults.add("release.polygon", "has no thickness and no volume",
               "give thickness, thickness_attribute or volume");
  }
  if (attribute && !release.polygon.coordinates.empty()) {
    faults.add("release.thickness_attribute", "a polygon given by coordinates has no attributes",
               "give thickness");
  }
}

void check_jitter(const ReleaseCase& release, Faults& faults) {
  if (release.seed == ReleaseCase{}.seed || release.jitter > 0 || faults.has("release.jitter"))
    return;
  faults.add("release.seed", "has no effect without jitter", "give jitter, 0.1 for instance");
}

void check_box(const ReleaseCase& release, Faults& faults) {
  if (!release.box) return;
  const auto& [x0, y0, z0, x1, y1, z1] = *release.box;
  if (!(x0 < x1 && y0 < y1 && z0 < z1)) {
    faults.add("release.box", "has no volume",
               "give [x0, y0, z0, x1, y1, z1], the lower corner first");
  }
}

/// What starts to move at once is not needed where something comes in.
void check_release(const ReleaseCase& release, bool is_needed, Faults& faults) {
  const bool by_pair = !release.dem_before.empty() || !release.dem_after.empty() ||
                       faults.has("release.dem_before") || faults.has("release.dem_after");
  const bool has_polygon = release.polygon.given() || faults.has("release.polygon");
  const bool by_polygon = has_polygon && !by_pair;
  const bool by_raster =
      !release.thickness_raster.empty() || faults.has("release.thickness_raster");
  const bool by_points = !release.points.empty() || faults.has("release.points");
  const bool by_box = release.box || faults.has("release.box");
  const bool thickness = release.thickness || faults.has("release.thickness");
  const bool volume = release.volume || faults.has("release.volume");

  check_polygon(release.polygon, "release.polygon", faults);
  check_box(release, faults);
  const int ways = by_pair + by_polygon + by_raster + by_points + by_box;
  if (ways > 1 || (ways == 0 && is_needed)) {
    faults.add("release",
               ways > 1 ? "the release is given in more than one way" : "nothing is released",
               ways > 1 ? "give one of polygon, thickness_raster, points, box, and dem_before with "
                          "dem_after"
                        : "give one of polygon, thickness_raster, points, box, and dem_before with "
                          "dem_after, or an [[inflow]]");
    return;
  }
  check_dem_pair(release, faults);
  check_jitter(release, faults);
  if (by_polygon) check_polygon_thickness(release, faults);
  if (!by_polygon && thickness) {
    faults.add("release.thickness", "applies to a polygon only", "remove it");
  }
  if (!by_polygon && !release.thickness_attribute.empty()) {
    faults.add("release.thickness_attribute", "applies to a polygon only", "remove it");
  }
  if (by_box && volume) {
    faults.add("release.volume", "does not apply to a box", "remove it, or change the box");
  }
  if (by_box && release.normal) {
    faults.add("release.normal", "does not apply to a box", "remove it");
  }
  if (by_points && volume) {
    faults.add("release.volume", "does not apply to points",
               "remove it; each point stands for point_volume");
  }
  if (by_points && release.normal) {
    faults.add("release.normal", "does not apply to points", "remove it");
  }
  if (!by_points && release.point_volume != ReleaseCase{}.point_volume) {
    faults.add("release.point_volume", "applies to points only", "remove it");
  }
  if (!by_points && release.points_offset != ReleaseCase{}.points_offset) {
    faults.add("release.points_offset", "applies to points only", "remove it");
  }
}

void check_gauge(const GaugeCase& gauge, const std::string& path, Faults& faults) {
  const bool has_place = gauge.place.has_value(), has_file = !gauge.file.empty();
  if (has_place != has_file || faults.has(path + ".place") || faults.has(path + ".file")) return;
  faults.add(path, has_place ? "has a place and a file" : "has no place",
             "give one of place = [x, y] and file");
}

/// A concentration stands for a viscosity; where both are given they must agree.
void check_concentration(const MaterialCase& material, Faults& faults) {
  const std::string key = "material.concentration";
  if (!material.concentration || faults.has(key) || faults.has("material.viscosity")) return;
  const std::optional<double> given = viscosity_of(material.law);
  const double meant = viscosity_of_concentration(*material.concentration);
  if (!given) {
    faults.add(key, fmt::format("rheology \"{}\" has no viscosity", name_of(material.law)),
               "remove it, or choose another rheology");
  } else if (std::abs(*given - meant) > 1e-6 * meant) {
    faults.add(key,
               fmt::format("gives a viscosity of {} Pa s, the key viscosity says {}",
                           short_text(meant), short_text(*given)),
               "remove one of the two");
  }
}

/// Keys of a wall law that was not chosen would do nothing.
void check_wall(const NumericsCase& numerics, Faults& faults) {
  const NumericsCase plain;
  const bool rubs = numerics.wall == WallLaw::coulomb || numerics.wall == WallLaw::voellmy;
  const struct {
    const char* key;
    bool is_given;
    bool applies;
    const char* laws;
  } rules[] = {
      {"numerics.wall_friction_angle", numerics.wall_friction_angle != plain.wall_friction_angle,
       rubs, "\"coulomb\" or \"voellmy\""},
      {"numerics.wall_cohesion", numerics.wall_cohesion != plain.wall_cohesion, rubs,
       "\"coulomb\" or \"voellmy\""},
      {"numerics.wall_turbulence", numerics.wall_turbulence != plain.wall_turbulence,
       numerics.wall == WallLaw::voellmy, "\"voellmy\""}};
  for (const auto& rule : rules) {
    if (!rule.is_given || rule.applies || faults.has("numerics.wall")) continue;
    faults.add(rule.key, fmt::format("does not apply to wall = \"{}\"", word_of(numerics.wall)),
               fmt::format("remove it, or choose wall = {}", rule.laws));
  }
  if (rubs && numerics.wall_friction_angle == 0 && numerics.wall_cohesion == 0 &&
      !faults.has("numerics.wall_friction_angle")) {
    faults.add("numerics.wall_friction_angle", "the wall has neither friction nor cohesion",
               "give an angle, or choose wall = \"slip\"");
  }
  if (numerics.wall != WallLaw::no_slip && numerics.method == Method::paper) {
    faults.add("numerics.wall", "applies to method \"fast\" only",
               "remove it, or choose boundary_stress");
  }
}

/// Keys that only the other method reads, as their help says, would do nothing.
void check_switches(const NumericsCase& numerics, Faults& faults) {
  const bool is_fast = numerics.method == Method::fast;
  const std::string_view other = word_of(is_fast ? Method::paper : Method::fast);
  const std::vector<ListedKey> given = list_keys(numerics), plain = list_keys(NumericsCase{});
  for (std::size_t k = 0; k < given.size(); ++k) {
    const std::string key = "numerics." + given[k].name;
    if (!given[k].help.starts_with(fmt::format("{}:", other)) || given[k].value == plain[k].value ||
        faults.has(key))
      continue;
    faults.add(key, fmt::format("applies to method \"{}\" only", other),
               fmt::format("remove it, or choose method = \"{}\"", other));
  }
}

void check_numerics(const NumericsCase& numerics, Faults& faults) {
  check_wall(numerics, faults);
  check_switches(numerics, faults);
  if (numerics.gravity == 0 && numerics.reference_speed == 0 &&
      !faults.has("numerics.reference_speed")) {
    faults.add("numerics.reference_speed", "without gravity nothing else sets the sound speed",
               "give a number above 0");
  }
}

/// Of one of the intervals of a run: how many of what it makes is too many.
struct MostOutputs {
  double count;
  const char* name;
};
constexpr MostOutputs most_frames{1e5, "frames"}, most_rows{1e7, "rows"},
    most_checkpoints{1000, "checkpoints"};

void check_interval(double interval, const char* name, const MostOutputs& most, double duration,
                    Faults& faults) {
  const std::string key = fmt::format("run.{}", name);
  if (duration <= interval * most.count || faults.has(key)) return;
  faults.add(key, fmt::format("makes more than {} {}", short_text(most.count), most.name),
             fmt::format("give at least {} s", short_text(duration / most.count)));
}

void check_checkpoints(const RunCase& run, Faults& faults) {
  if (run.kept_checkpoint_interval == 0 || faults.has("run.kept_checkpoint_interval")) return;
  if (run.checkpoint_interval == 0)
    faults.add("run.kept_checkpoint_interval", "no checkpoints are written",
               "give checkpoint_interval a number above 0");
  check_interval(run.kept_checkpoint_interval, "kept_checkpoint_interval", most_checkpoints,
                 run.duration, faults);
}

}  // namespace

void check_rules(const Case& c, Faults& faults) {
  check_ground(c.terrain, faults);
  check_crop(c.terrain, faults);
  for (std::size_t i = 0; i < c.terrain.edits.size(); ++i) {
    check_edit(c.terrain.edits[i], fmt::format("terrain.edit[{}]", i + 1), faults);
  }
  check_release(c.release, c.inflows.empty(), faults);
  check_inflows(c.inflows, faults);
  check_structures(c.structures, faults);
  check_bodies(c.bodies, faults);
  for (std::size_t i = 0; i < c.sections.size(); ++i) {
    check_line(c.sections[i].line, fmt::format("section[{}].line", i + 1), faults);
  }
  for (std::size_t i = 0; i < c.gauges.size(); ++i) {
    check_gauge(c.gauges[i], fmt::format("gauge[{}]", i + 1), faults);
  }
  for (std::size_t i = 0; i < c.zones.size(); ++i) {
    check_polygon(c.zones[i].polygon, fmt::format("zone[{}].polygon", i + 1), faults);
  }
  check_line(c.path.line, "path.line", faults);
  check_names(c.terrain.edits, "terrain.edit", faults);
  check_names(c.structures, "structure", faults);
  check_names(c.bodies, "body", faults);
  check_names(c.sections, "section", faults);
  check_names(c.gauges, "gauge", faults);
  check_names(c.zones, "zone", faults);
  check_names(c.references, "reference", faults);
  check_observed(c.observed, faults);
  check_concentration(c.material, faults);
  check_numerics(c.numerics, faults);
  check_interval(c.run.output_interval, "output_interval", most_frames, c.run.duration, faults);
  check_interval(c.run.series_interval, "series_interval", most_rows, c.run.duration, faults);
  check_checkpoints(c.run, faults);
}

}  // namespace sabo
