#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "input_file.hpp"
#include <gdal_priv.h>

#include "base/error.hpp"
#include "io/gis/gdal_errors.hpp"
#include "io/gis/read_vectors.hpp"

namespace {

void keep_geojson() {
  const sabo::GdalErrors registered;
  GDALDriverManager& drivers = *GetGDALDriverManager();
  for (int k = drivers.GetDriverCount() - 1; k >= 0; --k) {
    GDALDriver* const driver = drivers.GetDriver(k);
    if (std::string(driver->GetDescription()) == "GeoJSON") continue;
    drivers.DeregisterDriver(driver);
    delete driver;
  }
}

void check(const std::vector<sabo::Vec3d>& points) {
  for (const sabo::Vec3d& p : points)
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) __builtin_trap();
}

}  // namespace

/// Whatever the bytes: lines, points and polygons are refused or finite.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const bool is_ready = (keep_geojson(), true);
  if (!is_ready) return 0;
  const sabo::InputFile file(".geojson", data, size);
  try {
    for (const sabo::Polyline& line : sabo::read_lines(file.path(), "", "key"))
      check(line.vertices);
  } catch (const sabo::CaseError&) {
  }
  try {
    check(sabo::read_points(file.path(), "", "key"));
  } catch (const sabo::CaseError&) {
  }
  try {
    for (const sabo::Polygon& polygon : sabo::read_polygons(file.path(), "", "key"))
      for (const std::vector<sabo::Vec3d>& ring : polygon.rings) {
        if (ring.size() < 3) __builtin_trap();
        check(ring);
      }
  } catch (const sabo::CaseError&) {
  }
  return 0;
}
