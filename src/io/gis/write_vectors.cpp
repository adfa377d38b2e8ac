#include "io/gis/write_vectors.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include "base/error.hpp"
#include "io/gis/crs.hpp"
#include "io/gis/gdal_errors.hpp"
#include "io/gis/partial_file.hpp"

namespace sabo {
namespace {

struct NamedGeometry {
  std::string name;
  std::unique_ptr<OGRGeometry> geometry;
};

void add_points(OGRSimpleCurve& curve, const std::vector<Vec3d>& vertices, bool has_z) {
  for (const Vec3d& v : vertices) {
    has_z ? curve.addPoint(v.x, v.y, v.z) : curve.addPoint(v.x, v.y);
  }
}

bool write_layer(GDALDataset& data, const std::string& name, OGRwkbGeometryType type,
                 const std::vector<NamedGeometry>& geometries, const std::string& crs_wkt) {
  OGRSpatialReference crs = crs_of(crs_wkt);
  if (crs.IsEmpty()) crs.SetLocalCS("Undefined Cartesian SRS");  // GeoPackage's for plain metres
  OGRLayer* layer = data.CreateLayer(name.c_str(), &crs, type, nullptr);
  if (!layer) return false;
  OGRFieldDefn field("name", OFTString);
  if (layer->CreateField(&field) != OGRERR_NONE) return false;
  for (const NamedGeometry& row : geometries) {
    OGRFeature feature(layer->GetLayerDefn());
    feature.SetField("name", row.name.c_str());
    if (feature.SetGeometry(row.geometry.get()) != OGRERR_NONE) return false;
    if (layer->CreateFeature(&feature) != OGRERR_NONE) return false;
  }
  return true;
}

void write(const std::filesystem::path& file, OGRwkbGeometryType type,
           const std::vector<NamedGeometry>& geometries, const std::string& crs_wkt) {
  const GdalErrors errors;
  PartialFile partial(file);
  std::error_code ignored;
  std::filesystem::remove(partial.path(), ignored);  // the driver does not overwrite
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GPKG");
  GDALDatasetUniquePtr data(driver->Create(partial.path().c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  bool is_written = data != nullptr;
  if (is_written) {
    is_written = write_layer(*data, file.stem().string(), type, geometries, crs_wkt);
    data.reset();
  }
  if (!is_written || errors.failed()) {
    throw RunError(
        fmt::format("cannot write {}: {}", file.string(), errors.failure("the disk may be full")));
  }
  partial.commit();
}

}  // namespace

void write_lines(const std::filesystem::path& file, const std::vector<NamedLine>& lines,
                 const std::string& crs_wkt) {
  const bool has_z = std::ranges::any_of(lines, [](const auto& row) { return row.line.has_z; });
  std::vector<NamedGeometry> geometries;
  for (const NamedLine& row : lines) {
    auto line = std::make_unique<OGRLineString>();
    add_points(*line, row.line.vertices, has_z);
    geometries.push_back({row.name, std::move(line)});
  }
  write(file, has_z ? wkbLineString25D : wkbLineString, geometries, crs_wkt);
}

void write_polygons(const std::filesystem::path& file, const std::vector<NamedPolygon>& polygons,
                    const std::string& crs_wkt) {
  std::vector<NamedGeometry> geometries;
  for (const NamedPolygon& row : polygons) {
    auto polygon = std::make_unique<OGRPolygon>();
    for (const std::vector<Vec3d>& vertices : row.polygon.rings) {
      auto ring = std::make_unique<OGRLinearRing>();
      add_points(*ring, vertices, false);
      ring->closeRings();
      polygon->addRingDirectly(ring.release());
    }
    geometries.push_back({row.name, std::move(polygon)});
  }
  write(file, wkbPolygon, geometries, crs_wkt);
}

}  // namespace sabo
