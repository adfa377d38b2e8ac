#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "input_file.hpp"
#include <gdal_priv.h>

#include "base/error.hpp"
#include "io/gis/gdal_errors.hpp"
#include "io/gis/read_dem.hpp"

namespace {

/// GDAL as a user has it knows 200 formats; here are the two of DEMs, so that it is our reader that
/// is tried.
void keep_two_formats() {
  const sabo::GdalErrors registered;
  GDALDriverManager& drivers = *GetGDALDriverManager();
  for (int k = drivers.GetDriverCount() - 1; k >= 0; --k) {
    GDALDriver* const driver = drivers.GetDriver(k);
    const std::string name = driver->GetDescription();
    if (name == "AAIGrid" || name == "GTiff") continue;
    drivers.DeregisterDriver(driver);
    delete driver;
  }
  CPLSetConfigOption("GDAL_DISABLE_READDIR_ON_OPEN", "TRUE");
}

}  // namespace

/// Whatever the bytes: the DEM is refused, or one that a flow can run over.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const bool is_ready = (keep_two_formats(), true);
  if (!is_ready) return 0;
  const sabo::InputFile file(".dem", data, size);
  sabo::DemRequest request;
  request.file = file.path();
  request.assume_metres = true;
  try {
    const sabo::Dem dem = sabo::read_dem(request);
    const sabo::Grid& grid = dem.raster.grid;
    bool is_sound = grid.columns > 1 && grid.rows > 1 && grid.dx > 0 && grid.dy > 0 &&
                    std::isfinite(grid.west) && std::isfinite(grid.north) &&
                    dem.raster.values.size() == grid.size();
    for (const double z : dem.raster.values)
      is_sound = is_sound && !std::isinf(z) && !(std::abs(z) > 1e5);
    if (!is_sound) __builtin_trap();
  } catch (const sabo::CaseError&) {
  }
  return 0;
}
