#include "io/gis/write_ascii_grid.hpp"

#include <cmath>
#include <system_error>
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

// A dataset in memory, which the driver of the format copies: it cannot be written to by itself.
GDALDatasetUniquePtr in_memory(const Raster& raster, const std::string& crs_wkt) {
  const Grid& grid = raster.grid;
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("MEM");
  GDALDatasetUniquePtr data(driver->Create("", grid.columns, grid.rows, 1, GDT_Float32, nullptr));
  if (!data) return data;
  georeference(*data, grid, crs_wkt);
  GDALRasterBand& band = *data->GetRasterBand(1);
  band.SetNoDataValue(no_data_value);
  std::vector<float> values(raster.values.size());
  for (std::size_t cell = 0; cell < values.size(); ++cell) {
    const double value = raster.values[cell];
    values[cell] = std::isnan(value) ? no_data_value : static_cast<float>(value);
    if (std::isinf(values[cell]))
      throw RunError(fmt::format("value {} of cell {} is not finite", value, cell));
  }
  if (band.RasterIO(GF_Write, 0, 0, grid.columns, grid.rows, values.data(), grid.columns, grid.rows,
                    GDT_Float32, 0, 0, nullptr) != CE_None)
    data.reset();
  return data;
}

}  // namespace

void write_ascii_grid(const std::filesystem::path& file, const Raster& raster,
                      const std::string& crs_wkt) {
  const GdalErrors errors;
  const CPLConfigOptionSetter no_side_file("GDAL_PAM_ENABLED", "NO", false);
  PartialFile partial(file);
  CPLStringList options;
  options.SetNameValue("SIGNIFICANT_DIGITS", "9");
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("AAIGrid");
  const GDALDatasetUniquePtr source = in_memory(raster, crs_wkt);
  GDALDatasetUniquePtr copy(source ? driver->CreateCopy(partial.path().c_str(), source.get(), FALSE,
                                                        options.List(), nullptr, nullptr)
                                   : nullptr);
  const bool is_written = copy != nullptr;
  copy.reset();
  if (!is_written || errors.failed()) {
    throw RunError(
        fmt::format("cannot write {}: {}", file.string(), errors.failure("the disk may be full")));
  }
  const auto prj = [](std::filesystem::path path) { return path.replace_extension(".prj"); };
  std::error_code error;
  if (std::filesystem::exists(prj(partial.path()), error))
    std::filesystem::rename(prj(partial.path()), prj(file), error);
  else
    std::filesystem::remove(prj(file), error);  // of a former grid
  if (error)
    throw RunError(fmt::format("cannot write {}: {}", prj(file).string(), error.message()));
  partial.commit();
}

}  // namespace sabo
