#include "io/gis/georeference.hpp"

#include <array>

#include "io/gis/crs.hpp"

namespace sabo {

void georeference(GDALDataset& data, const Grid& grid, const std::string& crs_wkt) {
  std::array<double, 6> geotransform{grid.west, grid.dx, 0, grid.north, 0, -grid.dy};
  data.SetGeoTransform(geotransform.data());
  const OGRSpatialReference crs = crs_of(crs_wkt);
  if (!crs.IsEmpty()) data.SetSpatialRef(&crs);
}

}  // namespace sabo
