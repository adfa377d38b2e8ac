#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <cpl_conv.h>
#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

namespace sabo {

/// A GeoTIFF as somebody else's program might write it.
struct MadeRaster {
  int columns = 3;
  int rows = 2;
  std::vector<double> values{1, 2, 3, 4, 5, 6};
  std::array<double, 6> geotransform{100, 10, 0, 220, 0, -10};
  std::string crs = "EPSG:32654";  ///< metres; "" for none
  std::optional<double> nodata = {};
  int bands = 1;
  std::string unit = {};
  double scale = 1;
  double offset = 0;

  void write(const std::filesystem::path& file) const {
    GDALAllRegister();
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
    GDALDatasetUniquePtr data(
        driver->Create(file.c_str(), columns, rows, bands, GDT_Float64, nullptr));
    std::array<double, 6> transform = geotransform;
    data->SetGeoTransform(transform.data());
    if (!crs.empty()) {
      OGRSpatialReference reference;
      reference.SetFromUserInput(crs.c_str());
      data->SetSpatialRef(&reference);
    }
    GDALRasterBand& band = *data->GetRasterBand(1);
    if (nodata) band.SetNoDataValue(*nodata);
    if (!unit.empty()) band.SetUnitType(unit.c_str());
    if (scale != 1) band.SetScale(scale);
    if (offset != 0) band.SetOffset(offset);
    std::vector<double> copy = values;
    ASSERT_EQ(band.RasterIO(GF_Write, 0, 0, columns, rows, copy.data(), columns, rows, GDT_Float64,
                            0, 0, nullptr),
              CE_None);
  }
};

/// WKT of "EPSG:n".
inline std::string wkt_of_code(const std::string& code) {
  OGRSpatialReference crs;
  crs.SetFromUserInput(code.c_str());
  char* text = nullptr;
  crs.exportToWkt(&text);
  const std::string wkt = text;
  CPLFree(text);
  return wkt;
}

}  // namespace sabo
