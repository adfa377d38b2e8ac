#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "terrain/polyline.hpp"

namespace sabo {

/// An attribute of a layer; `is_number` decides its type.
struct LayerField {
  std::string name;
  bool is_number = false;
};

/// A geometry and its attributes in the order of the fields; a number that is not finite is left
/// out (NULL).
struct LayerRow {
  std::variant<Vec3d, Polyline, Polygon> geometry;
  std::vector<std::variant<std::string, double>> values = {};
};

/// Rows whose geometries are all of one kind, in plan or, if they are lines, with their heights.
struct VectorLayer {
  std::string name;
  std::vector<LayerField> fields = {};
  std::vector<LayerRow> rows = {};
  bool has_heights = false;
};

/// Writes a GeoPackage with the layers that have rows. `crs_wkt` may be "". An existing file is
/// replaced. Throws RunError with the reason, also when no layer has a row.
void write_layers(const std::filesystem::path& file, const std::vector<VectorLayer>& layers,
                  const std::string& crs_wkt);

}  // namespace sabo
