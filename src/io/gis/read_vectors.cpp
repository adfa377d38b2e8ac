#include "io/gis/read_vectors.hpp"

#include <cmath>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include "base/error.hpp"
#include "io/gis/crs.hpp"
#include "io/gis/gdal_errors.hpp"

namespace sabo {
namespace {

constexpr std::size_t max_vertices = 10'000'000;

using GeometryPtr = std::unique_ptr<OGRGeometry>;
using TransformPtr = std::unique_ptr<OGRCoordinateTransformation>;

// Simple geometries of one type, in the CRS of the DEM, out of the one layer that has any.
class VectorFile {
 public:
  VectorFile(const std::filesystem::path& file, std::string key)
      : key_(std::move(key)), name_(file.string()) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) {
      refuse("there is no such file", "give a path relative to the case file");
    }
    data_.reset(GDALDataset::Open(name_.c_str(), GDAL_OF_VECTOR | GDAL_OF_VERBOSE_ERROR));
    if (!data_) {
      refuse("cannot be read as a vector file: " + errors_.failure("unknown format"),
             "give a file that GDAL reads, such as GeoPackage, Shapefile or GeoJSON");
    }
  }

  // `type` is wkbLineString or wkbPolygon, `plural` its name in messages.
  std::vector<GeometryPtr> read(OGRwkbGeometryType type, const char* plural,
                                const std::string& dem_crs) {
    std::vector<GeometryPtr> found;
    std::string layers;
    std::string source;
    for (OGRLayer* layer : data_->GetLayers()) {
      std::vector<GeometryPtr> here = read_layer(*layer, type);
      const std::string name = fmt::format("\"{}\"", layer->GetName());
      layers += (layers.empty() ? "" : ", ") + name;
      if (here.empty()) continue;
      if (!found.empty()) {
        refuse(fmt::format("has {} in layers {} and {}", plural, source, name),
               "give a file with one of them");
      }
      reproject(here, *layer, dem_crs);
      found = std::move(here);
      source = name;
    }
    if (found.empty()) {
      refuse(fmt::format("has no {} (layers: {})", plural, layers.empty() ? "none" : layers),
             fmt::format("give a file with {}", plural));
    }
    return found;
  }

  [[noreturn]] void refuse(std::string problem, std::string remedy) const {
    throw CaseError(key_, name_ + " " + std::move(problem), std::move(remedy));
  }

  const GdalErrors& errors() const { return errors_; }

 private:
  std::vector<GeometryPtr> read_layer(OGRLayer& layer, OGRwkbGeometryType type) {
    std::vector<GeometryPtr> found;
    for (const auto& feature : layer) {
      if (GeometryPtr geometry{feature->StealGeometry()}) split(std::move(geometry), type, found);
    }
    if (errors_.failed()) refuse("is damaged: " + errors_.failure(""), "copy or make it again");
    return found;
  }

  // Takes collections apart and curves into straight pieces.
  void split(GeometryPtr geometry, OGRwkbGeometryType type, std::vector<GeometryPtr>& into) {
    if (geometry->IsEmpty()) return;
    if (geometry->hasCurveGeometry()) geometry.reset(geometry->getLinearGeometry());
    const OGRwkbGeometryType own = wkbFlatten(geometry->getGeometryType());
    if (own == type) {
      into.push_back(std::move(geometry));
    } else if (OGR_GT_IsSubClassOf(own, wkbGeometryCollection)) {
      for (const OGRGeometry* part : *geometry->toGeometryCollection()) {
        split(GeometryPtr{part->clone()}, type, into);
      }
    }
  }

  void reproject(std::vector<GeometryPtr>& geometries, OGRLayer& layer,
                 const std::string& dem_crs) {
    const OGRSpatialReference* own = layer.GetSpatialRef();
    const OGRSpatialReference target = horizontal(crs_of(dem_crs));
    if (!own || is_unknown(*own)) return;
    if (target.IsEmpty()) {
      if (!own->IsGeographic()) return;
      refuse("is in degrees (" + name_of(*own) + "), the DEM has no coordinate system",
             "give the DEM one, or give the file in the coordinates of the DEM");
    }
    if (same_place(*own, target)) return;
    const OGRSpatialReference from = horizontal(*own);
    const TransformPtr transform{OGRCreateCoordinateTransformation(&from, &target)};
    for (GeometryPtr& geometry : geometries) {
      if (transform && geometry->transform(transform.get()) == OGRERR_NONE) continue;
      refuse(fmt::format("cannot be brought from {} to {}: {}", name_of(*own), name_of(target),
                         errors_.failure("no transformation")),
             "correct the coordinate system of the file (GeoJSON without one is in degrees)");
    }
  }

  GdalErrors errors_;
  std::string key_;
  std::string name_;
  GDALDatasetUniquePtr data_;
};

// Vertices without repetitions of their predecessor in plan.
std::vector<Vec3d> vertices_of(const OGRLineString& line, const VectorFile& file,
                               std::size_t& total) {
  total += line.getNumPoints();
  if (total > max_vertices) {
    file.refuse(fmt::format("has more than {} vertices", max_vertices), "simplify it");
  }
  std::vector<Vec3d> vertices;
  vertices.reserve(line.getNumPoints());
  for (int i = 0; i < line.getNumPoints(); ++i) {
    const Vec3d v{line.getX(i), line.getY(i), line.getZ(i)};
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) {
      file.refuse("has a coordinate that is not a number", "correct it");
    }
    if (vertices.empty() || vertices.back().x != v.x || vertices.back().y != v.y) {
      vertices.push_back(v);
    }
  }
  return vertices;
}

}  // namespace

std::vector<Polyline> read_lines(const std::filesystem::path& file, const std::string& dem_crs,
                                 const std::string& key) {
  VectorFile source(file, key);
  std::vector<Polyline> lines;
  std::size_t total = 0;
  for (const GeometryPtr& geometry : source.read(wkbLineString, "lines", dem_crs)) {
    const OGRLineString& line = *geometry->toLineString();
    lines.push_back({vertices_of(line, source, total), line.Is3D() != 0});
    if (lines.back().vertices.size() < 2) {
      source.refuse("has a line of no length", "give it two different points or more");
    }
  }
  return lines;
}

std::vector<Polygon> read_polygons(const std::filesystem::path& file, const std::string& dem_crs,
                                   const std::string& key) {
  VectorFile source(file, key);
  std::vector<Polygon> polygons;
  std::size_t total = 0;
  for (const GeometryPtr& geometry : source.read(wkbPolygon, "polygons", dem_crs)) {
    Polygon& polygon = polygons.emplace_back();
    for (const OGRLinearRing* ring : *geometry->toPolygon()) {
      std::vector<Vec3d> vertices = vertices_of(*ring, source, total);
      const bool is_closed = vertices.size() > 1 && vertices.front().x == vertices.back().x &&
                             vertices.front().y == vertices.back().y;
      if (is_closed) vertices.pop_back();
      polygon.rings.push_back(std::move(vertices));
    }
    if (!geometry->IsValid()) {
      source.refuse("has an invalid polygon: " + source.errors().warning(),
                    "repair it, e.g. ogr2ogr -makevalid out.gpkg in.gpkg");
    }
  }
  return polygons;
}

}  // namespace sabo
