#include "io/gis/write_layers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include "base/error.hpp"
#include "io/gis/crs.hpp"
#include "io/gis/gdal_errors.hpp"
#include "io/gis/partial_file.hpp"

namespace sabo {
namespace {

using GeometryPtr = std::unique_ptr<OGRGeometry>;

GeometryPtr geometry_of(const Vec3d& point, bool /*has_heights*/) {
  return std::make_unique<OGRPoint>(point.x, point.y);
}

GeometryPtr geometry_of(const Polyline& line, bool has_heights) {
  auto curve = std::make_unique<OGRLineString>();
  for (const Vec3d& v : line.vertices)
    has_heights ? curve->addPoint(v.x, v.y, v.z) : curve->addPoint(v.x, v.y);
  return curve;
}

GeometryPtr geometry_of(const Polygon& from, bool /*has_heights*/) {
  auto polygon = std::make_unique<OGRPolygon>();
  for (const std::vector<Vec3d>& vertices : from.rings) {
    auto ring = std::make_unique<OGRLinearRing>();
    for (const Vec3d& v : vertices) ring->addPoint(v.x, v.y);
    ring->closeRings();
    polygon->addRingDirectly(ring.release());
  }
  return polygon;
}

OGRwkbGeometryType type_of(const VectorLayer& layer) {
  const std::array types{wkbPoint, layer.has_heights ? wkbLineString25D : wkbLineString,
                         wkbPolygon};
  return types[layer.rows.front().geometry.index()];
}

void set(OGRFeature& feature, int field, const std::variant<std::string, double>& value) {
  if (const auto* text = std::get_if<std::string>(&value)) {
    feature.SetField(field, text->c_str());
  } else if (std::isfinite(std::get<double>(value))) {
    feature.SetField(field, std::get<double>(value));
  }
}

bool write_layer(GDALDataset& data, const VectorLayer& rows, OGRSpatialReference& crs) {
  OGRLayer* layer = data.CreateLayer(rows.name.c_str(), &crs, type_of(rows), nullptr);
  if (!layer) return false;
  for (const LayerField& field : rows.fields) {
    OGRFieldDefn definition(field.name.c_str(), field.is_number ? OFTReal : OFTString);
    if (layer->CreateField(&definition) != OGRERR_NONE) return false;
  }
  for (const LayerRow& row : rows.rows) {
    OGRFeature feature(layer->GetLayerDefn());
    for (std::size_t k = 0; k < row.values.size() && k < rows.fields.size(); ++k)
      set(feature, static_cast<int>(k), row.values[k]);
    const GeometryPtr geometry = std::visit(
        [&](const auto& shape) { return geometry_of(shape, rows.has_heights); }, row.geometry);
    if (feature.SetGeometry(geometry.get()) != OGRERR_NONE) return false;
    if (layer->CreateFeature(&feature) != OGRERR_NONE) return false;
  }
  return true;
}

}  // namespace

void write_layers(const std::filesystem::path& file, const std::vector<VectorLayer>& layers,
                  const std::string& crs_wkt) {
  if (std::ranges::all_of(layers, [](const VectorLayer& layer) { return layer.rows.empty(); }))
    throw RunError(fmt::format("{} would hold nothing", file.string()));
  const GdalErrors errors;
  OGRSpatialReference crs = crs_of(crs_wkt);
  if (crs.IsEmpty()) crs.SetLocalCS("Undefined Cartesian SRS");  // GeoPackage's for plain metres
  PartialFile partial(file);
  std::error_code ignored;
  std::filesystem::remove(partial.path(), ignored);  // the driver does not overwrite
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GPKG");
  GDALDatasetUniquePtr data(driver->Create(partial.path().c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  bool is_written = data != nullptr;
  for (const VectorLayer& layer : layers)
    if (is_written && !layer.rows.empty()) is_written = write_layer(*data, layer, crs);
  data.reset();
  if (!is_written || errors.failed()) {
    throw RunError(
        fmt::format("cannot write {}: {}", file.string(), errors.failure("the disk may be full")));
  }
  partial.commit();
}

}  // namespace sabo
