#include "io/gis/write_raster.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <cpl_conv.h>
#include <cpl_string.h>
#include <fmt/format.h>
#include <gdal_priv.h>

#include "base/error.hpp"
#include "io/gis/gdal_errors.hpp"
#include "io/gis/georeference.hpp"
#include "io/gis/partial_file.hpp"

namespace sabo {
namespace {

void describe(GDALDataset& data, const Grid& grid, const RasterInfo& info) {
  georeference(data, grid, info.crs_wkt);
  for (const auto& [key, value] : info.metadata) data.SetMetadataItem(key.c_str(), value.c_str());
  GDALRasterBand& band = *data.GetRasterBand(1);
  band.SetNoDataValue(no_data_value);
  band.SetDescription(info.description.c_str());
  if (!info.unit.empty()) band.SetUnitType(info.unit.c_str());
}

bool write_values(GDALRasterBand& band, const Raster& raster) {
  const Grid& grid = raster.grid;
  std::vector<float> line(grid.columns);
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const double value = raster.at(column, row);
      if (std::abs(value) > std::numeric_limits<float>::max()) {
        throw RunError(
            fmt::format("value {} at column {}, row {} is not finite", value, column, row));
      }
      line[column] = std::isnan(value) ? no_data_value : static_cast<float>(value);
    }
    const CPLErr result = band.RasterIO(GF_Write, 0, row, grid.columns, 1, line.data(),
                                        grid.columns, 1, GDT_Float32, 0, 0, nullptr);
    if (result != CE_None) return false;
  }
  return true;
}

}  // namespace

void write_raster(const std::filesystem::path& file, const Raster& raster, const RasterInfo& info) {
  const GdalErrors errors;
  // What a GeoTIFF cannot hold is left out rather than put in an .aux.xml beside it.
  const CPLConfigOptionSetter no_side_file("GDAL_PAM_ENABLED", "NO", false);
  PartialFile partial(file);
  CPLStringList options;
  options.SetNameValue("COMPRESS", "DEFLATE");
  options.SetNameValue("PREDICTOR", "3");
  options.SetNameValue("BIGTIFF", "IF_SAFER");

  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  GDALDatasetUniquePtr data(driver->Create(partial.path().c_str(), raster.grid.columns,
                                           raster.grid.rows, 1, GDT_Float32, options.List()));
  bool is_written = data != nullptr;
  if (is_written) {
    describe(*data, raster.grid, info);
    is_written = write_values(*data->GetRasterBand(1), raster);
    data.reset();  // the last blocks are written here, so errors are looked at afterwards
  }
  if (!is_written || errors.failed()) {
    throw RunError(
        fmt::format("cannot write {}: {}", file.string(), errors.failure("the disk may be full")));
  }
  partial.commit();
}

}  // namespace sabo
