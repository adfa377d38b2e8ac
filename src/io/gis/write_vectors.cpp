#include "io/gis/write_vectors.hpp"

#include <algorithm>

#include "io/gis/write_layers.hpp"

namespace sabo {
namespace {

VectorLayer layer_for(const std::filesystem::path& file) {
  return {file.stem().string(), {{"name"}}};
}

}  // namespace

void write_lines(const std::filesystem::path& file, const std::vector<NamedLine>& lines,
                 const std::string& crs_wkt) {
  VectorLayer layer = layer_for(file);
  layer.has_heights = std::ranges::any_of(lines, [](const auto& row) { return row.line.has_z; });
  for (const NamedLine& row : lines) layer.rows.push_back({row.line, {row.name}});
  write_layers(file, {layer}, crs_wkt);
}

void write_polygons(const std::filesystem::path& file, const std::vector<NamedPolygon>& polygons,
                    const std::string& crs_wkt) {
  VectorLayer layer = layer_for(file);
  for (const NamedPolygon& row : polygons) layer.rows.push_back({row.polygon, {row.name}});
  write_layers(file, {layer}, crs_wkt);
}

}  // namespace sabo
