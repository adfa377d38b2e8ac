#include "io/gis/check_elevations.hpp"

#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include "base/counted.hpp"
#include "base/error.hpp"
#include "io/gis/crs.hpp"

namespace sabo {
namespace {

// There is no ground deeper or higher. The deepest of any lake is at -1187 m (Baikal), and where
// rasters have no data they often have -9999.
constexpr double lowest_elevation = -5000, highest_elevation = 12000;  // m

}  // namespace

void check_elevation_unit(const RasterFile& file) {
  const OGRSpatialReference& crs = file.crs();
  const char* vertical = nullptr;
  if (crs.IsCompound() && !is_metre(crs.GetTargetLinearUnits("VERT_CS", &vertical))) {
    file.refuse(fmt::format("has elevations in units of {}: {}", vertical, name_of(crs)),
                "convert the elevations to metres");
  }
  const std::string unit = file.unit();
  for (const char* metre : {"", "m", "metre", "metres", "meter", "meters", "unknown"}) {
    if (unit == metre) return;
  }
  file.refuse(fmt::format("has elevations in \"{}\", not metres", unit),
              "convert them, or correct the unit of the band");
}

void check_elevations(const std::string& key, const std::string& name, const Raster& raster) {
  std::size_t valid = 0;
  std::size_t absurd = 0;
  double example = 0;
  for (const double z : raster.values) {
    if (std::isnan(z)) continue;
    ++valid;
    if (z >= lowest_elevation && z <= highest_elevation) continue;
    if (absurd++ == 0) example = z;
  }
  if (valid == 0) {
    throw CaseError(key, name + " has no data in any cell",
                    "choose another raster, or another window of it");
  }
  if (absurd > 0) {
    throw CaseError(
        key,
        fmt::format("{} has {} of {:.9g} m or the like, which is no elevation", name,
                    counted(absurd, "cell"), example),
        fmt::format("declare that value as nodata, e.g. gdal_edit.py -a_nodata {:.9g}", example));
  }
}

}  // namespace sabo
