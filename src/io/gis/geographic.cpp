#include "io/gis/geographic.hpp"

#include <cmath>
#include <memory>

#include "io/gis/crs.hpp"
#include "io/gis/gdal_errors.hpp"

namespace sabo {

std::optional<Geographic> geographic(const std::string& crs_wkt, double x, double y) {
  const GdalErrors errors;
  const OGRSpatialReference source = horizontal(crs_of(crs_wkt));
  if (is_unknown(source)) return std::nullopt;
  OGRSpatialReference target;
  target.importFromEPSG(4326);
  target.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const std::unique_ptr<OGRCoordinateTransformation> transformation(
      OGRCreateCoordinateTransformation(&source, &target));
  const bool is_done = transformation && transformation->Transform(1, &x, &y);
  if (!is_done || !std::isfinite(x) || !std::isfinite(y)) return std::nullopt;
  return Geographic{y, x};
}

}  // namespace sabo
