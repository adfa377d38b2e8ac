#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "terrain/polyline.hpp"

namespace sabo {

/// All lines of a vector file in any format of OGR, in the CRS of the DEM (`dem_crs`: its WKT, ""
/// for a DEM without one, whose coordinates are then taken to be those of the file). Multi-lines
/// are split, z is kept as it is. Throws CaseError at `key`, the key of the case that names the
/// file: unreadable, no line in it, lines in more than one layer, not finite, not reprojectable.
std::vector<Polyline> read_lines(const std::filesystem::path& file, const std::string& dem_crs,
                                 const std::string& key);

/// All points of a file, as read_lines() does lines; z is 0 where the file has none.
std::vector<Vec3d> read_points(const std::filesystem::path& file, const std::string& dem_crs,
                               const std::string& key);

/// A polygon and the number that an attribute of its feature holds; NaN if none was asked for.
struct ValuedPolygon {
  Polygon polygon;
  double value = 0;
};

/// Polygons with their values of `attribute` ("" for none); refuses a file that lacks it and a
/// feature without a value.
std::vector<ValuedPolygon> read_valued_polygons(const std::filesystem::path& file,
                                                const std::string& dem_crs, const std::string& key,
                                                const std::string& attribute);

/// All polygons of a file, as read_lines() does lines; rings that cross themselves or each other
/// are refused.
std::vector<Polygon> read_polygons(const std::filesystem::path& file, const std::string& dem_crs,
                                   const std::string& key);

/// Code of the coordinate system of a vector file, "EPSG:31287"; "" without one, and for one that
/// PROJ's database does not know. Throws CaseError at `key`.
std::string code_of_vectors(const std::filesystem::path& file, const std::string& key);

}  // namespace sabo
