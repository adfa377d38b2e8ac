#include "io/gis/raster_file.hpp"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/gis/crs.hpp"

namespace sabo {

RasterFile::RasterFile(const std::filesystem::path& file, std::string key)
    : key_(std::move(key)), name_(file.string()) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) {
    refuse("there is no such file", "give a path relative to the case file");
  }
  data_.reset(GDALDataset::Open(name_.c_str(), GDAL_OF_RASTER | GDAL_OF_VERBOSE_ERROR));
  if (!data_) {
    refuse("cannot be read as a raster: " + errors_.failure("unknown format"),
           "give a raster that GDAL reads, such as GeoTIFF or ESRI ASCII");
  }
  if (data_->GetRasterCount() != 1) {
    refuse(fmt::format("has {} bands, one is needed", data_->GetRasterCount()),
           "extract one band, e.g. gdal_translate -b 1 in.tif out.tif");
  }
  band_ = data_->GetRasterBand(1);
  if (const OGRSpatialReference* crs = data_->GetSpatialRef()) crs_ = *crs;
  crs_.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  read_geotransform();
}

void RasterFile::read_geotransform() {
  std::array<double, 6> g{};
  if (data_->GetGeoTransform(g.data()) != CE_None) {
    refuse("has no position on the map (no geotransform)", "georeference it");
  }
  for (double value : g) {
    if (!std::isfinite(value)) refuse("has a geotransform that is not finite", "georeference it");
  }
  if (g[2] != 0 || g[4] != 0 || !(g[1] > 0) || g[5] == 0) {
    refuse("is rotated or mirrored", "warp it to a north-up grid, e.g. gdalwarp in.tif out.tif");
  }
  south_up_ = g[5] > 0;
  grid_.columns = data_->GetRasterXSize();
  grid_.rows = data_->GetRasterYSize();
  grid_.dx = g[1];
  grid_.dy = std::abs(g[5]);
  grid_.west = g[0];
  grid_.north = south_up_ ? g[3] + grid_.rows * grid_.dy : g[3];
}

Raster RasterFile::read(const CellWindow& window) const {
  const Grid grid = part_of(grid_, window);
  if (grid.size() > max_cells) {
    refuse(
        fmt::format("has {} x {} cells, more than {} in all", grid.columns, grid.rows, max_cells),
        "read a part of it (terrain.crop) or make it coarser");
  }
  Raster raster(grid);
  for (int row = 0; row < grid.rows; ++row) {
    read_row(window, window.row + row, &raster.values[grid.index(0, row)]);
  }
  return raster;
}

void RasterFile::read_row(const CellWindow& window, int row, double* values) const {
  const int line = south_up_ ? grid_.rows - 1 - row : row;
  const auto read_line = [&](GDALRasterBand* band, void* into, GDALDataType type) {
    const CPLErr result = band->RasterIO(GF_Read, window.column, line, window.columns, 1, into,
                                         window.columns, 1, type, 0, 0, nullptr);
    if (result != CE_None) {
      refuse("is damaged: " + errors_.failure("a row cannot be read"), "copy or make it again");
    }
  };
  read_line(band_, values, GDT_Float64);

  std::vector<GByte> mask(window.columns, 255);
  if (band_->GetMaskFlags() != GMF_ALL_VALID)
    read_line(band_->GetMaskBand(), mask.data(), GDT_Byte);

  int has_nodata = 0;
  const double nodata = band_->GetNoDataValue(&has_nodata);
  const double scale = band_->GetScale();
  const double offset = band_->GetOffset();
  for (int column = 0; column < window.columns; ++column) {
    double& value = values[column];
    const bool is_data = mask[column] != 0 && std::isfinite(value) &&
                         !(has_nodata && static_cast<float>(value) == static_cast<float>(nodata));
    value = is_data ? value * scale + offset : Raster::no_data;
  }
}

void RasterFile::refuse(std::string problem, std::string remedy) const {
  throw CaseError(key_, name_ + " " + std::move(problem), std::move(remedy));
}

}  // namespace sabo
