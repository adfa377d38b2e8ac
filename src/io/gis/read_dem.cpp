#include "io/gis/read_dem.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/gis/check_elevations.hpp"
#include "io/gis/crs.hpp"
#include "io/gis/raster_file.hpp"

namespace sabo {
namespace {

bool is_metre(double unit) { return std::abs(unit - 1) < 1e-9; }

void check_crs(const RasterFile& file, bool assume_metres) {
  const OGRSpatialReference& crs = file.crs();
  if (is_unknown(crs)) {
    if (assume_metres) return;
    file.refuse("has no coordinate system",
                "give it one (gdal_edit.py -a_srs EPSG:CODE), or set terrain.assume_metres = true");
  }
  const char* const remedy =
      "reproject it to metres, e.g. gdalwarp -t_srs EPSG:CODE in.tif out.tif";
  const std::string name = name_of(crs);
  if (crs.IsGeographic()) file.refuse("is in degrees: " + name, remedy);
  if (!crs.IsProjected()) file.refuse("is not in a projected coordinate system: " + name, remedy);
  const char* unit = nullptr;
  if (!is_metre(crs.GetLinearUnits(&unit))) {
    file.refuse(fmt::format("is in units of {}, not metres: {}", unit, name), remedy);
  }
  if (crs.IsCompound() && !is_metre(crs.GetTargetLinearUnits("VERT_CS", &unit))) {
    file.refuse(fmt::format("has elevations in units of {}: {}", unit, name),
                "convert the elevations to metres");
  }
}

void check_unit(const RasterFile& file) {
  const std::string unit = file.unit();
  for (const char* metre : {"", "m", "metre", "metres", "meter", "meters", "unknown"}) {
    if (unit == metre) return;
  }
  file.refuse(fmt::format("has elevations in \"{}\", not metres", unit),
              "convert them, or correct the unit of the band");
}

// The cells that touch [west, south, east, north].
CellWindow window_of(const RasterFile& file, const std::array<double, 4>& crop) {
  const auto& [west, south, east, north] = crop;
  const Grid& grid = file.grid();
  if (!(west < east && south < north)) {
    throw CaseError("terrain.crop", "the window is empty",
                    "give [west, south, east, north] with west < east and south < north");
  }
  constexpr double slack = 1e-6;  // cells: a window along cell edges takes no further cells
  const auto clipped = [](double cell, int count) {
    return static_cast<int>(std::clamp(cell, 0.0, static_cast<double>(count)));
  };
  CellWindow window;
  window.column = clipped(std::floor((west - grid.west) / grid.dx + slack), grid.columns);
  window.row = clipped(std::floor((grid.north - north) / grid.dy + slack), grid.rows);
  window.columns =
      clipped(std::ceil((east - grid.west) / grid.dx - slack), grid.columns) - window.column;
  window.rows = clipped(std::ceil((grid.north - south) / grid.dy - slack), grid.rows) - window.row;
  if (window.columns < 2 || window.rows < 2) {
    throw CaseError("terrain.crop", "the window holds less than 2 x 2 cells of " + file.name(),
                    fmt::format("choose it within [{:.9g}, {:.9g}, {:.9g}, {:.9g}]", grid.west,
                                grid.south(), grid.east(), grid.north));
  }
  return window;
}

}  // namespace

Dem read_dem(const std::filesystem::path& file, bool assume_metres,
             const std::optional<std::array<double, 4>>& crop) {
  const RasterFile source(file, "terrain.dem");
  const Grid& grid = source.grid();
  if (grid.columns < 2 || grid.rows < 2) {
    source.refuse(fmt::format("has {} x {} cells", grid.columns, grid.rows),
                  "give a raster of at least 2 x 2 cells");
  }
  check_crs(source, assume_metres);
  check_unit(source);
  Raster raster = crop ? source.read(window_of(source, *crop)) : source.read();
  check_elevations("terrain.dem", source.name(), raster);
  return {std::move(raster), is_unknown(source.crs()) ? "" : wkt_of(source.crs()), file};
}

}  // namespace sabo
