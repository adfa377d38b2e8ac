#pragma once

#include <string>

#include <ogr_spatialref.h>

namespace sabo {

/// The coordinate system that terrain.crs asks for, e.g. "EPSG:6691" or a WKT; x is east. Throws
/// CaseError at terrain.crs when it is unknown, in degrees, or not projected in metres.
OGRSpatialReference target_crs(const std::string& text);

/// The coordinate system of an EPSG code that is known to exist; x is east.
OGRSpatialReference crs_of_code(int code);

}  // namespace sabo
