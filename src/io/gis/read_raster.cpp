#include "io/gis/read_raster.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/counted.hpp"
#include "io/gis/check_elevations.hpp"
#include "io/gis/crs.hpp"
#include "io/gis/raster_file.hpp"

namespace sabo {
namespace {

void check_crs(const RasterFile& file, const RasterPlace& place) {
  const OGRSpatialReference& crs = file.crs();
  const OGRSpatialReference dem = crs_of(place.dem_crs);
  if (is_unknown(crs)) {
    if (dem.IsEmpty() || place.assume_metres) return;
    file.refuse("has no coordinate system, the DEM has " + name_of(dem),
                "give it that one (gdal_edit.py -a_srs), or set terrain.assume_metres = true");
  }
  if (dem.IsEmpty()) {
    if (crs.IsProjected()) return;
    file.refuse(fmt::format("is in {}, the DEM has no coordinate system", name_of(crs)),
                "give the DEM one, or bring the raster to the coordinates of the DEM");
  }
  if (!same_place(crs, dem)) {
    file.refuse(fmt::format("is in {}, the DEM in {}", name_of(crs), name_of(dem)),
                "reproject it (gdalwarp -t_srs), or correct its tag if that is wrong "
                "(gdal_edit.py -a_srs)");
  }
}

void check_values(const RasterFile& file, const Raster& raster) {
  const auto is_negative = [](double thickness) { return thickness < 0; };
  const auto first = std::ranges::find_if(raster.values, is_negative);
  if (first != raster.values.end()) {
    const auto count = std::count_if(first, raster.values.end(), is_negative);
    file.refuse(
        fmt::format("has {} of negative thickness, e.g. {:.9g} m", counted(count, "cell"), *first),
        "declare that value as nodata, or set those cells to 0");
  }
  const auto has_mass = [](double thickness) { return thickness > 0; };
  if (std::ranges::none_of(raster.values, has_mass)) {
    file.refuse("has no cell of positive thickness", "give the thickness in metres");
  }
}

}  // namespace

Raster read_thickness(const std::filesystem::path& file, const RasterPlace& place) {
  const RasterFile source(file, place.key);
  check_crs(source, place);
  Raster raster = source.read();
  check_values(source, raster);
  return raster;
}

Raster read_elevation(const std::filesystem::path& file, const RasterPlace& place) {
  const RasterFile source(file, place.key);
  check_crs(source, place);
  check_elevation_unit(source);
  Raster raster = source.read();
  check_elevations(place.key, source.name(), raster);
  return raster;
}

}  // namespace sabo
