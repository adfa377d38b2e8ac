#include "io/gis/target_crs.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/shown_text.hpp"
#include "io/gis/crs.hpp"
#include "io/gis/gdal_errors.hpp"

namespace sabo {
namespace {

[[noreturn]] void refuse(const std::string& problem) {
  throw CaseError("terrain.crs", problem,
                  "give a projected coordinate system in metres, e.g. \"EPSG:6691\" "
                  "(JGD2011 / UTM zone 54N)");
}

}  // namespace

OGRSpatialReference target_crs(const std::string& text) {
  const GdalErrors errors;
  OGRSpatialReference crs;
  // Without the network and without files: the same text has the same meaning everywhere.
  const OGRErr result = crs.SetFromUserInput(
      text.c_str(), OGRSpatialReference::SET_FROM_USER_INPUT_LIMITATIONS_get());
  if (result != OGRERR_NONE) {
    refuse(fmt::format("\"{}\" is no coordinate system: {}", shown_text(text),
                       errors.failure("unknown form")));
  }
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const std::string name = name_of(crs);
  if (crs.IsGeographic()) refuse(name + " is in degrees");
  if (!crs.IsProjected()) refuse(name + " is not a projected coordinate system");
  if (is_web_mercator(crs)) refuse(name + " stretches lengths");
  const char* unit = nullptr;
  if (!is_metre(crs.GetLinearUnits(&unit))) {
    refuse(fmt::format("{} is in units of {}, not metres", name, unit));
  }
  if (crs.IsCompound() && !is_metre(crs.GetTargetLinearUnits("VERT_CS", &unit))) {
    refuse(fmt::format("{} has elevations in units of {}, not metres", name, unit));
  }
  return crs;
}

OGRSpatialReference crs_of_code(int code) {
  const GdalErrors errors;
  OGRSpatialReference crs;
  if (crs.importFromEPSG(code) != OGRERR_NONE) {
    throw RunError(fmt::format("PROJ does not know EPSG:{}: {}", code,
                               errors.failure("its database is missing or too old")));
  }
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return crs;
}

}  // namespace sabo
