#include "post/observed_data.hpp"

#include <algorithm>
#include <cmath>

#include "post/map_difference.hpp"
#include <fmt/format.h>

#include "base/error.hpp"
#include "io/gis/crs.hpp"
#include "io/gis/file_kind.hpp"
#include "io/gis/raster_file.hpp"
#include "io/gis/read_raster.hpp"
#include "io/gis/read_vectors.hpp"
#include "run/scene_lines.hpp"
#include "terrain/cells_within.hpp"

namespace sabo {
namespace {

/// The solver frame plays no part: the origin is that of the CRS.
Frame frame_of(const RunMap& map) { return {0, 0, map.crs_wkt}; }

void put_file(const std::filesystem::path& file, ObservedCase& observed) {
  switch (kind_of_gis_file(file)) {
    case GisFileKind::raster:
      observed.depth_raster = file;
      observed.outline = {};
      return;
    case GisFileKind::vectors:
      observed.depth_raster.clear();
      observed.outline = LineSource{file, {}, false};
      return;
    case GisFileKind::unknown:
      break;
  }
  throw CaseError("--observed",
                  fmt::format("{} cannot be read as a raster or as vectors", file.string()),
                  "give a file that GDAL reads, such as GeoTIFF or GeoPackage");
}

bool compares_deposit(const ObservedCase& observed) {
  if (observed.map == ComparedMap::automatic) return !observed.depth_raster.empty();
  return observed.map == ComparedMap::deposit;
}

Raster observed_depths(const FinishedRun& run, const ObservedCase& observed, ObservedData& data) {
  const RunMap& like = data.simulated;
  const RasterPlace place{"observed.depth_raster", like.crs_wkt,
                          run.run_case().terrain.assume_metres};
  RunMap survey{"observed.depth_raster", read_thickness(observed.depth_raster, place), like.crs_wkt,
                "", "m"};
  AlignedMap on_grid = aligned(std::move(survey), like);
  if (!on_grid.note.empty()) data.notes.push_back("the survey was " + on_grid.note);
  for (double& depth : on_grid.map.raster.values)
    if (std::isnan(depth)) depth = 0;
  return std::move(on_grid.map.raster);
}

Raster observed_mask(const ObservedCase& observed, const RunMap& like) {
  const std::vector<Polygon> polygons =
      read_area(observed.outline, "observed.outline", frame_of(like));
  Raster mask(like.raster.grid);
  for (const std::size_t cell : cells_within(mask.grid, polygons)) mask.values[cell] = 1;
  return mask;
}

std::vector<std::size_t> compared_cells(const ObservedCase& observed, const RunMap& like) {
  std::vector<std::size_t> cells;
  if (observed.within.given()) {
    cells = cells_within(like.raster.grid,
                         read_area(observed.within, "observed.within", frame_of(like)));
  } else {
    for (std::size_t cell = 0; cell < like.raster.values.size(); ++cell) cells.push_back(cell);
  }
  std::erase_if(cells, [&](std::size_t cell) { return std::isnan(like.raster.values[cell]); });
  return cells;
}

}  // namespace

ObservedCase observed_case(const FinishedRun& run, const ObservedOptions& options) {
  ObservedCase observed = run.run_case().observed;
  if (!options.file.empty()) {
    put_file(options.file, observed);
    observed.source = options.file.filename().string();
  }
  if (options.wet_depth) {
    if (!(*options.wet_depth >= 0 && *options.wet_depth <= 100))
      throw CaseError("--wet", fmt::format("{} is not a depth", *options.wet_depth),
                      "give a number from 0 to 100 m");
    observed.wet_depth = *options.wet_depth;
  }
  if (!options.map.empty()) {
    const auto map = value_of_word<ComparedMap>(options.map);
    if (!map)
      throw CaseError("--map", fmt::format("\"{}\" is not known", options.map),
                      "give deposit or peak_depth");
    observed.map = *map;
  }
  if (!observed.has_footprint() && observed.arrivals.empty()) {
    const std::string& problem = run.case_problem();
    throw CaseError(run.folder().string(),
                    problem.empty() ? "its case has no [observed] to compare with"
                                    : "its case cannot be read: " + problem,
                    "give --observed FILE, or a second run");
  }
  return observed;
}

ObservedData read_observed(const FinishedRun& run, const ObservedCase& observed) {
  ObservedData data;
  data.wet = observed.wet_depth;
  data.simulated = run.map(compares_deposit(observed) ? "dep" : "pfd");
  data.has_depths = !observed.depth_raster.empty();
  data.observed = data.has_depths ? observed_depths(run, observed, data)
                                  : observed_mask(observed, data.simulated);
  data.cells = compared_cells(observed, data.simulated);
  const auto is_wet = [&](std::size_t cell) {
    return data.observed.values[cell] > data.observed_wet();
  };
  if (std::ranges::none_of(data.cells, is_wet))
    throw CaseError(data.has_depths ? "observed.depth_raster" : "observed.outline",
                    "nothing of it is wet on the map of the run, or in the surveyed area",
                    "check its coordinates, its unit (m) and the threshold");
  return data;
}

}  // namespace sabo
