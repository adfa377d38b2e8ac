#include "io/output/plan_file.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include "base/error.hpp"
#include "io/gis/crs.hpp"
#include "io/gis/gdal_errors.hpp"
#include "io/output/file.hpp"
#include "io/output/json.hpp"

namespace sabo {
namespace {

std::string coordinates_of(const Polyline& line) {
  std::string text;
  for (const Vec3d& v : line.vertices) {
    text += fmt::format("{}[{:.3f}, {:.3f}", text.empty() ? "" : ", ", v.x, v.y);
    if (line.has_z) text += fmt::format(", {:.3f}", v.z);
    text += "]";
  }
  return text;
}

/// RFC 7946 knows degrees only; GDAL and QGIS read this member of the format before it.
std::string crs_member(const std::string& crs_wkt) {
  const std::string code = code_of(crs_of(crs_wkt));
  const std::size_t colon = code.find(':');
  if (colon == std::string::npos) return "";
  return fmt::format(
      "\"crs\": {{\"type\": \"name\", \"properties\": {{\"name\": "
      "\"urn:ogc:def:crs:{}::{}\"}}}},\n",
      code.substr(0, colon), code.substr(colon + 1));
}

Polyline line_of(const OGRLineString& geometry) {
  Polyline line;
  line.has_z = geometry.Is3D();
  for (int k = 0; k < geometry.getNumPoints(); ++k) {
    const Vec3d vertex{geometry.getX(k), geometry.getY(k), line.has_z ? geometry.getZ(k) : 0};
    const bool is_finite =
        std::isfinite(vertex.x) && std::isfinite(vertex.y) && std::isfinite(vertex.z);
    if (is_finite) line.vertices.push_back(vertex);
  }
  return line;
}

}  // namespace

void write_plan(const std::filesystem::path& file, const std::vector<MapLine>& lines,
                const std::string& crs_wkt) {
  std::string features;
  for (const MapLine& line : lines) {
    if (line.line.vertices.size() < 2) continue;
    features += fmt::format(
        "{}{{\"type\": \"Feature\", \"properties\": {{\"kind\": {}, \"name\": {}, \"label\": {}, "
        "\"filled\": {}}}, "
        "\"geometry\": {{\"type\": \"LineString\", \"coordinates\": [{}]}}}}",
        features.empty() ? "" : ",\n", json_string(std::string(word_of(line.kind))),
        json_string(line.name_or_label()), json_string(line.label), line.is_filled,
        coordinates_of(line.line));
  }
  const GdalErrors errors;
  write_file_atomically(
      file, fmt::format("{{\"type\": \"FeatureCollection\",\n{}\"features\": [\n{}\n]}}\n",
                        crs_member(crs_wkt), features));
}

std::vector<MapLine> read_plan(const std::filesystem::path& file) {
  const GdalErrors errors;
  constexpr std::array drivers{"GeoJSON", static_cast<const char*>(nullptr)};
  const GDALDatasetUniquePtr data(
      GDALDataset::Open(file.c_str(), GDAL_OF_VECTOR | GDAL_OF_VERBOSE_ERROR, drivers.data()));
  if (!data)
    throw CaseError(file.string(), "cannot be read: " + errors.failure("unknown format"),
                    "run the case again");
  std::vector<MapLine> lines;
  for (OGRLayer* layer : data->GetLayers()) {
    for (const auto& feature : layer) {
      const int kind_field = feature->GetFieldIndex("kind");
      const int name_field = feature->GetFieldIndex("name");
      const OGRGeometry* geometry = feature->GetGeometryRef();
      if (kind_field < 0 || name_field < 0 || !geometry) continue;
      const auto kind = value_of_word<MapLine::Kind>(feature->GetFieldAsString(kind_field));
      if (!kind || wkbFlatten(geometry->getGeometryType()) != wkbLineString) continue;
      Polyline line = line_of(*geometry->toLineString());
      if (line.vertices.size() < 2) continue;
      const int filled_field = feature->GetFieldIndex("filled");
      const bool is_filled = filled_field >= 0 && feature->GetFieldAsInteger(filled_field) != 0;
      const std::string name = feature->GetFieldAsString(name_field);
      const int label_field = feature->GetFieldIndex("label");  // not in files of former versions
      const std::string label = label_field < 0 ? name : feature->GetFieldAsString(label_field);
      lines.push_back({*kind, label, std::move(line), is_filled, name});
    }
  }
  return lines;
}

}  // namespace sabo
