#include "io/gis/warp.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include <cpl_string.h>
#include <fmt/format.h>
#include <gdal_priv.h>
#include <gdal_utils.h>

#include "base/error.hpp"
#include "io/gis/crs.hpp"
#include "io/gis/gdal_errors.hpp"
#include "io/gis/round_length.hpp"

namespace sabo {
namespace {

using Bounds = std::array<double, 4>;

bool is_same(const OGRSpatialReference& a, const OGRSpatialReference& b) {
  return (a.IsEmpty() && b.IsEmpty()) || same_place(a, b);
}

Bounds transformed(const Bounds& bounds, const OGRSpatialReference& from,
                   const OGRSpatialReference& to) {
  if (is_same(from, to)) return bounds;
  const GdalErrors errors;
  const OGRSpatialReference source = horizontal(from);
  const OGRSpatialReference target = horizontal(to);
  const std::unique_ptr<OGRCoordinateTransformation> transformation(
      OGRCreateCoordinateTransformation(&source, &target));
  constexpr int points_per_edge = 21;  // edges become curves
  Bounds result{};
  auto& [west, south, east, north] = result;
  const bool is_done = transformation && transformation->TransformBounds(
                                             bounds[0], bounds[1], bounds[2], bounds[3], &west,
                                             &south, &east, &north, points_per_edge);
  const auto is_finite = [](double value) { return std::isfinite(value); };
  if (!is_done || !std::ranges::all_of(result, is_finite) || !(west < east && south < north)) {
    throw CaseError("terrain.crs",
                    fmt::format("the DEM cannot be brought from {} to {}: {}", name_of(from),
                                name_of(to), errors.failure("it lies outside of their use")),
                    "choose a coordinate system for the region of the DEM");
  }
  return result;
}

Bounds bounds_of(const Grid& grid) { return {grid.west, grid.south(), grid.east(), grid.north}; }

// Width and height of the middle cell in the units of the target.
std::array<double, 2> cell_in(const Grid& source, const OGRSpatialReference& from,
                              const OGRSpatialReference& to) {
  if (is_same(from, to)) return {source.dx, source.dy};
  const double x = source.west + source.columns / 2 * source.dx;
  const double y = source.north - source.rows / 2 * source.dy;
  const Bounds cell = transformed({x, y - source.dy, x + source.dx, y}, from, to);
  return {cell[2] - cell[0], cell[3] - cell[1]};
}

double own_cell_size(const Grid& source, const std::array<double, 2>& cell,
                     const OGRSpatialReference& from) {
  const bool is_square = std::abs(source.dx - source.dy) <= 1e-9 * source.dx;
  if (from.IsProjected() && from.GetLinearUnits() == 1 && is_square) return source.dx;
  return round_length(cell[1]);
}

int count_of(double count) {
  // Ends at 2^30 cells so that sums stay integers; far fewer can be held.
  if (count >= 2 && count < (1 << 30)) return static_cast<int>(count);
  throw CaseError("terrain.cell_size", fmt::format("gives {:.0f} cells across the DEM", count),
                  count < 2 ? "choose smaller cells" : "choose larger cells");
}

GDALDatasetUniquePtr dataset_over(const Raster& raster, const OGRSpatialReference& crs) {
  const Grid& grid = raster.grid;
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("MEM");
  GDALDatasetUniquePtr data(driver->Create("", grid.columns, grid.rows, 0, GDT_Float64, nullptr));
  std::array<char, 32> address{};
  // The warper writes into the values of a target, which is ours and not constant.
  CPLPrintPointer(address.data(), const_cast<double*>(raster.values.data()), address.size() - 1);
  CPLStringList options;
  options.SetNameValue("DATAPOINTER", address.data());
  data->AddBand(GDT_Float64, options.List());
  std::array<double, 6> geotransform{grid.west, grid.dx, 0, grid.north, 0, -grid.dy};
  data->SetGeoTransform(geotransform.data());
  if (!crs.IsEmpty()) {
    const OGRSpatialReference plan_view = horizontal(crs);
    data->SetSpatialRef(&plan_view);
  }
  data->GetRasterBand(1)->SetNoDataValue(Raster::no_data);
  return data;
}

CPLStringList warp_arguments(bool averages) {
  CPLStringList arguments;
  const auto add = [&](std::initializer_list<const char*> words) {
    for (const char* word : words) arguments.AddString(word);
  };
  add({"-r", averages ? "average" : "bilinear", "-srcnodata", "nan", "-dstnodata", "nan"});
  add({"-wo", "INIT_DEST=NO_DATA", "-wo", "NUM_THREADS=1", "-novshift"});
  add({"-et", "0.001"});  // cells that a place may be off for speed
  // Else the reach of the kernel follows the ratio of the cells in each chunk.
  if (!averages) add({"-wo", "XSCALE=1", "-wo", "YSCALE=1"});
  return arguments;
}

}  // namespace

WarpPlan plan_warp(const Grid& source, const OGRSpatialReference& from,
                   const OGRSpatialReference& to, double cell_size) {
  const std::array<double, 2> cell = cell_in(source, from, to);
  const double size = cell_size > 0 ? cell_size : own_cell_size(source, cell, from);
  constexpr double slack = 1e-6;  // cells
  WarpPlan plan;
  plan.averages = size > std::max(cell[0], cell[1]) * (1 + slack);
  Grid& grid = plan.grid;
  grid.dx = grid.dy = size;
  auto [west, south, east, north] = transformed(bounds_of(source), from, to);
  if (!is_same(from, to)) {
    west = std::floor(west / size + slack) * size;
    north = std::ceil(north / size - slack) * size;
  }
  grid.west = west;
  grid.north = north;
  grid.columns = count_of(std::ceil((east - west) / size - slack));
  grid.rows = count_of(std::ceil((north - south) / size - slack));
  return plan;
}

std::array<double, 4> source_bounds(const Grid& target, const Grid& source,
                                    const OGRSpatialReference& from,
                                    const OGRSpatialReference& to) {
  auto [west, south, east, north] = transformed(bounds_of(target), to, from);
  constexpr double margin = 3;  // cells: one for the interpolation, the rest for curved edges
  return {west - margin * source.dx, south - margin * source.dy, east + margin * source.dx,
          north + margin * source.dy};
}

Raster warp(const Raster& source, const OGRSpatialReference& from, const WarpPlan& plan,
            const OGRSpatialReference& to) {
  const GdalErrors errors;
  Raster target(plan.grid, Raster::no_data);
  const GDALDatasetUniquePtr source_data = dataset_over(source, from);
  GDALDatasetUniquePtr target_data = dataset_over(target, to);
  using Options = std::unique_ptr<GDALWarpAppOptions, decltype(&GDALWarpAppOptionsFree)>;
  const Options options(GDALWarpAppOptionsNew(warp_arguments(plan.averages).List(), nullptr),
                        &GDALWarpAppOptionsFree);
  GDALDatasetH input = GDALDataset::ToHandle(source_data.get());
  const bool is_done = options && GDALWarp(nullptr, GDALDataset::ToHandle(target_data.get()), 1,
                                           &input, options.get(), nullptr);
  target_data->FlushCache();
  if (!is_done || errors.failed()) {
    throw CaseError(
        "terrain.dem", "the DEM cannot be resampled: " + errors.failure("unknown reason"),
        "resample it beforehand, e.g. gdalwarp -t_srs EPSG:CODE -tr 5 5 in.tif out.tif");
  }
  return target;
}

}  // namespace sabo
