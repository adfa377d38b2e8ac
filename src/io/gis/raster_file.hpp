#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include <gdal_priv.h>

#include "io/gis/crop_window.hpp"
#include "io/gis/gdal_errors.hpp"
#include "terrain/raster.hpp"

namespace sabo {

/// A raster of one band opened for reading. Whatever is wrong with it is a CaseError at `key`, the
/// key of the case that names the file.
class RasterFile {
 public:
  /// Bounds the memory: 3.2 GB of values.
  static constexpr std::size_t max_cells = 400'000'000;

  /// Refuses what cannot be opened, has not exactly one band, is rotated or not georeferenced.
  RasterFile(const std::filesystem::path& file, std::string key);

  const Grid& grid() const { return grid_; }
  /// Empty when the file has none.
  const OGRSpatialReference& crs() const { return crs_; }
  /// Unit of the values as the file names it, e.g. "ft"; "" when it has none.
  std::string unit() const { return band_->GetUnitType(); }
  /// Of the band, e.g. "greatest vertical depth"; "" when it has none.
  std::string description() const { return band_->GetDescription(); }
  const std::string& name() const { return name_; }

  /// Values of a window, scale and offset applied; NaN for nodata, masked and non-finite cells.
  Raster read(const CellWindow& window) const;
  Raster read() const { return read({0, 0, grid_.columns, grid_.rows}); }

  [[noreturn]] void refuse(std::string problem, std::string remedy) const;

 private:
  void read_geotransform();
  void read_row(const CellWindow& window, int row, double* values) const;

  GdalErrors errors_;
  std::string key_;
  std::string name_;
  GDALDatasetUniquePtr data_;
  GDALRasterBand* band_ = nullptr;
  OGRSpatialReference crs_;
  Grid grid_;
  bool south_up_ = false;
};

}  // namespace sabo
