#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "terrain/polyline.hpp"

namespace sabo {

struct NamedLine {
  std::string name;
  Polyline line;
};

struct NamedPolygon {
  std::string name;
  Polygon polygon;
};

/// Writes a GeoPackage of one layer with the attribute `name`, z where the lines have it. `crs_wkt`
/// may be "". An existing file is replaced. Throws RunError with the reason, also when there is
/// nothing to write.
void write_lines(const std::filesystem::path& file, const std::vector<NamedLine>& lines,
                 const std::string& crs_wkt);
void write_polygons(const std::filesystem::path& file, const std::vector<NamedPolygon>& polygons,
                    const std::string& crs_wkt);

}  // namespace sabo
