#pragma once

#include <cmath>
#include <string>

#include <ogr_spatialref.h>

namespace sabo {

/// Coordinate system from its WKT, x first (east) whatever the authority says. Empty for "".
OGRSpatialReference crs_of(const std::string& wkt);

/// Whether it says nothing of where on Earth: empty, local, or one of GeoPackage's two "undefined"
/// ones, which files without a CRS get there.
bool is_unknown(const OGRSpatialReference& crs);

/// A copy with x first and without a vertical part: what matters for a place on the map.
OGRSpatialReference horizontal(const OGRSpatialReference& crs);

/// WKT 2 on one line; "" for an empty one.
std::string wkt_of(const OGRSpatialReference& crs);

/// Its code in PROJ's database, "EPSG:31287"; "" where that does not know it.
std::string code_of(const OGRSpatialReference& crs);

/// For messages, e.g. "EPSG:5266 (DRUKREF 03 / Bhutan National Grid)".
std::string name_of(const OGRSpatialReference& crs);

/// Whether a unit, in metres, is the metre.
inline bool is_metre(double unit) { return std::abs(unit - 1) < 1e-9; }

/// Whether its metres are longer than metres, by 1 over the cosine of the latitude: that of tiled
/// maps on the web (EPSG:3857).
bool is_web_mercator(const OGRSpatialReference& crs);

/// Whether the two place a point alike; vertical parts are not compared.
bool same_place(const OGRSpatialReference& a, const OGRSpatialReference& b);

}  // namespace sabo
