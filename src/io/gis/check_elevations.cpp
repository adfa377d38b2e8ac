#include "io/gis/check_elevations.hpp"

#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include "base/error.hpp"

namespace sabo {
namespace {

constexpr double highest_elevation = 12000;  // m; deeper or higher there is no ground

}  // namespace

void check_elevations(const std::string& key, const std::string& name, const Raster& raster) {
  std::size_t valid = 0;
  std::size_t absurd = 0;
  double example = 0;
  for (const double z : raster.values) {
    if (std::isnan(z)) continue;
    ++valid;
    if (std::abs(z) <= highest_elevation) continue;
    if (absurd++ == 0) example = z;
  }
  if (valid == 0) {
    throw CaseError(key, name + " has no data in any cell",
                    "choose another raster or another terrain.crop");
  }
  if (absurd > 0) {
    throw CaseError(
        key,
        fmt::format("{} has {} cells like {:.9g} m, which is no elevation", name, absurd, example),
        fmt::format("declare that value as nodata, e.g. gdal_edit.py -a_nodata {:.9g}", example));
  }
}

}  // namespace sabo
