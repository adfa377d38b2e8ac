#include "io/case_file/check_rules.hpp"

#include <cmath>
#include <map>

#include <fmt/format.h>

#include "io/case_file/key_text.hpp"

namespace sabo {
namespace {

constexpr double max_frames = 1e5;
constexpr double max_rows = 1e7;

void check_crop(const TerrainCase& terrain, Faults& faults) {
  if (!terrain.crop) return;
  const auto& [west, south, east, north] = *terrain.crop;
  if (!(west < east && south < north)) {
    faults.add("terrain.crop", "the window is empty", "give [west, south, east, north]");
  }
}

/// Length in plan of a line given by coordinates, m.
double plan_length(const LineSource& line) {
  double length = 0;
  for (std::size_t i = 1; i < line.coordinates.size(); ++i) {
    const auto& a = line.coordinates[i - 1];
    const auto& b = line.coordinates[i];
    length += std::hypot(b[0] - a[0], b[1] - a[1]);
  }
  return length;
}

void check_line(const LineSource& line, const std::string& key, Faults& faults) {
  if (!line.coordinates.empty() && !(plan_length(line) > 0)) {
    faults.add(key, "all its points are at one place", "give a line of some length");
  }
}

void check_release(const ReleaseCase& release, Faults& faults) {
  const bool by_polygon = release.polygon.given() || faults.has("release.polygon");
  const bool by_raster =
      !release.thickness_raster.empty() || faults.has("release.thickness_raster");
  const bool by_points = !release.points.empty() || faults.has("release.points");
  const bool thickness = release.thickness || faults.has("release.thickness");
  const bool volume = release.volume || faults.has("release.volume");

  if (by_polygon + by_raster + by_points != 1) {
    faults.add("release",
               by_polygon || by_raster || by_points ? "the release is given in more than one way"
                                                    : "nothing is released",
               "give one of polygon, thickness_raster and points");
    return;
  }
  if (by_polygon && thickness + volume != 1) {
    faults.add("release.polygon",
               thickness ? "has a thickness and a volume" : "has no thickness and no volume",
               "give one of the two");
  }
  const std::size_t corners = release.polygon.coordinates.size();
  if (corners > 0 && corners < 3) {
    faults.add("release.polygon", "has fewer than three points", "give three or more");
  }
  if (!by_polygon && thickness) {
    faults.add("release.thickness", "applies to a polygon only", "remove it");
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

void check_crest(const StructureCase& dam, const std::string& path, Faults& faults) {
  const bool crest = dam.crest || faults.has(path + ".crest");
  const bool height = dam.height || faults.has(path + ".height");
  if (crest && height) {
    faults.add(path, "has a crest and a height", "give one of the two");
  } else if (dam.line.has_z && (crest || height)) {
    faults.add(path + (crest ? ".crest" : ".height"), "the z of the line is the crest already",
               "remove one of the two");
  } else if (!dam.line.coordinates.empty() && !dam.line.has_z && !crest && !height) {
    faults.add(path, "has no crest", "give crest, height, or a line with z");
  }
}

void check_notch(const StructureCase& dam, const std::string& path, Faults& faults) {
  if (!dam.notch) return;
  if (dam.height && dam.notch->depth > *dam.height) {
    faults.add(path + ".notch.depth", "the notch is deeper than the dam is high",
               fmt::format("give at most {} m", short_text(*dam.height)));
  }
  const double length = plan_length(dam.line);
  if (length > 0 && dam.notch->centre > length) {
    faults.add(path + ".notch.centre", "lies beyond the end of the line",
               fmt::format("give a distance along the line, at most {} m", short_text(length)));
  }
}

/// Names stand for their owners in the outputs.
template <class T>
void check_names(const std::vector<T>& members, const std::string& table, Faults& faults) {
  std::map<std::string, std::size_t> first;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const auto [earlier, is_new] = first.emplace(members[i].name, i);
    if (is_new) continue;
    faults.add(fmt::format("{}[{}].name", table, i + 1),
               fmt::format("\"{}\" is the name of {}[{}] too", members[i].name, table,
                           earlier->second + 1),
               "give each its own name");
  }
}

void check_numerics(const NumericsCase& numerics, Faults& faults) {
  if (numerics.gravity == 0 && numerics.reference_speed == 0 &&
      !faults.has("numerics.reference_speed")) {
    faults.add("numerics.reference_speed", "without gravity nothing else sets the sound speed",
               "give a number above 0");
  }
}

void check_interval(double interval, const std::string& key, double max_count, double duration,
                    Faults& faults) {
  if (duration <= interval * max_count || faults.has("run." + key)) return;
  faults.add("run." + key, fmt::format("makes more than {} outputs", short_text(max_count)),
             fmt::format("give at least {} s", short_text(duration / max_count)));
}

}  // namespace

void check_rules(const Case& c, Faults& faults) {
  check_crop(c.terrain, faults);
  check_line(c.release.polygon, "release.polygon", faults);
  check_release(c.release, faults);
  for (std::size_t i = 0; i < c.structures.size(); ++i) {
    const std::string path = fmt::format("structure[{}]", i + 1);
    check_line(c.structures[i].line, path + ".line", faults);
    check_crest(c.structures[i], path, faults);
    check_notch(c.structures[i], path, faults);
  }
  for (std::size_t i = 0; i < c.sections.size(); ++i) {
    check_line(c.sections[i].line, fmt::format("section[{}].line", i + 1), faults);
  }
  check_line(c.path.line, "path.line", faults);
  check_names(c.structures, "structure", faults);
  check_names(c.sections, "section", faults);
  check_names(c.references, "reference", faults);
  check_numerics(c.numerics, faults);
  check_interval(c.run.output_interval, "output_interval", max_frames, c.run.duration, faults);
  check_interval(c.run.series_interval, "series_interval", max_rows, c.run.duration, faults);
}

}  // namespace sabo
