#include "io/gis/read_dem.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/gis/check_elevations.hpp"
#include "io/gis/crop_window.hpp"
#include "io/gis/crs.hpp"
#include "io/gis/fg_gml_files.hpp"
#include "io/gis/raster_file.hpp"
#include "io/gis/read_fg_gml.hpp"
#include "io/gis/target_crs.hpp"
#include "io/gis/warp.hpp"

namespace sabo {
namespace {

// What is there before anything is done to it.
struct Source {
  std::string name;
  Grid grid;
  OGRSpatialReference crs;  // empty for a raster without one
  std::function<Raster(const CellWindow&)> read;
};

void check_crs(const RasterFile& file, bool assume_metres) {
  const OGRSpatialReference& crs = file.crs();
  if (is_unknown(crs)) {
    if (assume_metres) return;
    file.refuse("has no coordinate system",
                "name the one it is in with terrain.crs, e.g. \"EPSG:6691\", or set "
                "terrain.assume_metres = true");
  }
  const char* const remedy =
      "set terrain.crs to a projected one in metres, e.g. \"EPSG:6691\" (JGD2011 / UTM zone 54N)";
  const std::string name = name_of(crs);
  if (crs.IsGeographic()) file.refuse("is in degrees: " + name, remedy);
  if (!crs.IsProjected()) file.refuse("is not in a projected coordinate system: " + name, remedy);
  if (is_web_mercator(crs)) file.refuse("is in " + name + ", which stretches lengths", remedy);
  const char* unit = nullptr;
  if (!is_metre(crs.GetLinearUnits(&unit))) {
    file.refuse(fmt::format("is in units of {}, not metres: {}", unit, name), remedy);
  }
}

CellWindow whole(const Grid& grid) { return {0, 0, grid.columns, grid.rows}; }

// Brings the source to a coordinate system and a cell size; reads what that needs.
Raster warped(const Source& source, const OGRSpatialReference& target, const DemRequest& request,
              std::vector<std::string>& notes) {
  const bool moves = !source.crs.IsEmpty() && !same_place(source.crs, target);
  const OGRSpatialReference from = moves ? source.crs : target;
  WarpPlan plan = plan_warp(source.grid, from, target, request.cell_size);
  if (request.crop)
    plan.grid = part_of(plan.grid, crop_window(plan.grid, *request.crop, source.name));
  if (plan.grid.size() > RasterFile::max_cells) {
    throw CaseError("terrain.cell_size",
                    fmt::format("gives {} x {} cells, more than {} in all", plan.grid.columns,
                                plan.grid.rows, RasterFile::max_cells),
                    "choose larger cells or a smaller terrain.crop");
  }
  const CellWindow needed =
      cells_touching(source.grid, source_bounds(plan.grid, source.grid, from, target));
  if (needed.columns < 1 || needed.rows < 1) {
    throw CaseError("terrain.crop", "the window lies beside the data of " + source.name,
                    "choose it within the data");
  }
  const Raster read = source.read(needed);
  check_elevations("terrain.dem", source.name, read);
  const char* const how = plan.averages ? "mean of the cells below" : "bilinear";
  notes.push_back(moves ? fmt::format("reprojected from {} to {}, cells of {:g} m, {}",
                                      name_of(source.crs), name_of(target), plan.grid.dx, how)
                        : fmt::format("resampled from cells of {:g} x {:g} m to {:g} m, {}",
                                      source.grid.dx, source.grid.dy, plan.grid.dx, how));
  return warp(read, from, plan, target);
}

Dem made(const Source& source, const OGRSpatialReference& target, const DemRequest& request) {
  const Grid& grid = source.grid;
  const bool moves = !source.crs.IsEmpty() && !same_place(source.crs, target);
  const double size = request.cell_size;
  const bool resizes = size > 0 && (size != grid.dx || size != grid.dy);
  Dem dem;
  dem.crs_wkt = wkt_of(target);
  if (moves || resizes) {
    dem.raster = warped(source, target, request, dem.notes);
  } else {
    dem.raster =
        source.read(request.crop ? crop_window(grid, *request.crop, source.name) : whole(grid));
  }
  check_elevations("terrain.dem", source.name, dem.raster);
  return dem;
}

Dem from_raster(const DemRequest& request) {
  const RasterFile file(request.file, "terrain.dem");
  const Grid& grid = file.grid();
  if (grid.columns < 2 || grid.rows < 2) {
    file.refuse(fmt::format("has {} x {} cells", grid.columns, grid.rows),
                "give a raster of at least 2 x 2 cells");
  }
  const bool has_target = !request.crs.empty();
  if (!has_target) check_crs(file, request.assume_metres);
  check_elevation_unit(file);
  const bool is_known = !is_unknown(file.crs());
  const OGRSpatialReference own = is_known ? file.crs() : OGRSpatialReference();
  const OGRSpatialReference target = has_target ? target_crs(request.crs) : own;
  const Source source{file.name(), grid, own,
                      [&](const CellWindow& window) { return file.read(window); }};
  Dem dem = made(source, target, request);
  if (has_target && !is_known) {
    dem.notes.insert(dem.notes.begin(),
                     "has no coordinate system, taken to be in " + name_of(target));
  }
  return dem;
}

Dem from_fg_gml(DemRequest request) {
  const bool has_target = !request.crs.empty();
  OGRSpatialReference target;
  if (has_target) target = target_crs(request.crs);
  const FgGmlDem tiles = read_fg_gml(request.file);
  const Grid& grid = tiles.raster.grid;
  if (!has_target) target = crs_of_code(utm_code(tiles.datum, (grid.west + grid.east()) / 2));
  if (request.cell_size == 0) request.cell_size = tiles.cell_size;
  const Source source{request.file.string(), grid, crs_of_code(geographic_code(tiles.datum)),
                      [&](const CellWindow& window) {
                        Raster part(part_of(grid, window));
                        for (int row = 0; row < window.rows; ++row) {
                          const double* const from =
                              &tiles.raster.values[grid.index(window.column, window.row + row)];
                          std::copy_n(from, window.columns, &part.at(0, row));
                        }
                        return part;
                      }};
  Dem dem = made(source, target, request);
  dem.notes.insert(dem.notes.begin(), tiles.note);
  return dem;
}

}  // namespace

Dem read_dem(const DemRequest& request) {
  const double size = request.cell_size;
  if (!std::isfinite(size) || size < 0) {
    throw CaseError("terrain.cell_size", fmt::format("is {} m", size), "give a positive length");
  }
  return may_be_fg_gml(request.file) ? from_fg_gml(request) : from_raster(request);
}

}  // namespace sabo
