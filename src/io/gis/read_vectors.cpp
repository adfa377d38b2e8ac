#include "io/gis/read_vectors.hpp"

#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include "base/error.hpp"
#include "base/parsed_number.hpp"
#include "io/gis/crs.hpp"
#include "io/gis/gdal_errors.hpp"

namespace sabo {
namespace {

constexpr std::size_t max_vertices = 10'000'000;

using GeometryPtr = std::unique_ptr<OGRGeometry>;
using TransformPtr = std::unique_ptr<OGRCoordinateTransformation>;

// A simple geometry and what the wanted attribute of its feature says; NaN without one.
struct Piece {
  GeometryPtr geometry;
  double value = std::numeric_limits<double>::quiet_NaN();
};

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

  /// Attribute whose numbers are read along; must be set before read().
  void want(const std::string& attribute) { attribute_ = attribute; }

  // `type` is wkbPoint, wkbLineString or wkbPolygon, `plural` its name in messages.
  std::vector<Piece> read(OGRwkbGeometryType type, const char* plural, const std::string& dem_crs) {
    std::vector<Piece> found;
    std::string layers;
    std::string source;
    for (OGRLayer* layer : data_->GetLayers()) {
      std::vector<Piece> here = read_layer(*layer, type);
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

  // Of the first layer; empty without one.
  OGRSpatialReference crs() const {
    const OGRLayer* layer = data_->GetLayerCount() > 0 ? data_->GetLayer(0) : nullptr;
    const OGRSpatialReference* own =
        layer ? const_cast<OGRLayer*>(layer)->GetSpatialRef() : nullptr;
    return own && !is_unknown(*own) ? *own : OGRSpatialReference();
  }

  [[noreturn]] void refuse(std::string problem, std::string remedy) const {
    throw CaseError(key_, name_ + " " + std::move(problem), std::move(remedy));
  }

  const GdalErrors& errors() const { return errors_; }

 private:
  std::vector<Piece> read_layer(OGRLayer& layer, OGRwkbGeometryType type) {
    std::vector<Piece> found;
    for (const auto& feature : layer) {
      const std::size_t first = found.size();
      if (GeometryPtr geometry{feature->StealGeometry()}) split(std::move(geometry), type, found);
      if (attribute_.empty() || found.size() == first) continue;
      const double value = value_of(*feature);
      for (std::size_t k = first; k < found.size(); ++k) found[k].value = value;
    }
    if (errors_.failed()) refuse("is damaged: " + errors_.failure(""), "copy or make it again");
    return found;
  }

  // The number in the wanted attribute of a feature.
  double value_of(const OGRFeature& feature) const {
    const int index = feature.GetFieldIndex(attribute_.c_str());
    if (index < 0) {
      std::string names;
      for (int k = 0; k < feature.GetFieldCount(); ++k) {
        names +=
            fmt::format("{}\"{}\"", k > 0 ? ", " : "", feature.GetFieldDefnRef(k)->GetNameRef());
      }
      refuse(fmt::format("has no attribute \"{}\"", attribute_),
             names.empty() ? "give it that attribute" : "use one of: " + names);
    }
    if (!feature.IsFieldSetAndNotNull(index)) {
      refuse(fmt::format("has a feature without a value of \"{}\"", attribute_), "fill it in");
    }
    if (feature.GetFieldDefnRef(index)->GetType() != OFTString)
      return feature.GetFieldAsDouble(index);
    const std::string text = feature.GetFieldAsString(index);
    const auto number = parsed_number<double>(text);
    if (!number)
      refuse(
          fmt::format("has a feature whose \"{}\" is \"{}\", which is no number", attribute_, text),
          "give numbers with a decimal point and without a unit");
    return *number;
  }

  // Takes collections apart and curves into straight pieces.
  void split(GeometryPtr geometry, OGRwkbGeometryType type, std::vector<Piece>& into) {
    if (geometry->IsEmpty()) return;
    if (geometry->hasCurveGeometry()) geometry.reset(geometry->getLinearGeometry());
    const OGRwkbGeometryType own = wkbFlatten(geometry->getGeometryType());
    if (own == type) {
      into.push_back({std::move(geometry)});
    } else if (OGR_GT_IsSubClassOf(own, wkbGeometryCollection)) {
      for (const OGRGeometry* part : *geometry->toGeometryCollection()) {
        split(GeometryPtr{part->clone()}, type, into);
      }
    }
  }

  void reproject(std::vector<Piece>& pieces, OGRLayer& layer, const std::string& dem_crs) {
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
    for (const auto& [geometry, value] : pieces) {
      if (transform && geometry->transform(transform.get()) == OGRERR_NONE) continue;
      refuse(fmt::format("cannot be brought from {} to {}: {}", name_of(*own), name_of(target),
                         errors_.failure("no transformation")),
             "correct the coordinate system of the file (GeoJSON without one is in degrees)");
    }
  }

  GdalErrors errors_;
  std::string key_;
  std::string name_;
  std::string attribute_;
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
  for (const auto& [geometry, value] : source.read(wkbLineString, "lines", dem_crs)) {
    const OGRLineString& line = *geometry->toLineString();
    lines.push_back({vertices_of(line, source, total), line.Is3D() != 0});
    if (lines.back().vertices.size() < 2) {
      source.refuse("has a line of no length", "give it two different points or more");
    }
  }
  return lines;
}

std::vector<Vec3d> read_points(const std::filesystem::path& file, const std::string& dem_crs,
                               const std::string& key) {
  VectorFile source(file, key);
  std::vector<Vec3d> points;
  for (const auto& [geometry, value] : source.read(wkbPoint, "points", dem_crs)) {
    const OGRPoint& point = *geometry->toPoint();
    points.push_back({point.getX(), point.getY(), point.getZ()});
    if (!std::isfinite(norm(points.back())))
      source.refuse("has a coordinate that is not a number", "correct it");
    if (points.size() > max_vertices)
      source.refuse(fmt::format("has more than {} points", max_vertices), "leave some out");
  }
  return points;
}

std::string code_of_vectors(const std::filesystem::path& file, const std::string& key) {
  const OGRSpatialReference crs = VectorFile(file, key).crs();
  return crs.IsEmpty() ? "" : code_of(crs);
}

std::vector<ValuedPolygon> read_valued_polygons(const std::filesystem::path& file,
                                                const std::string& dem_crs, const std::string& key,
                                                const std::string& attribute) {
  VectorFile source(file, key);
  source.want(attribute);
  std::vector<ValuedPolygon> polygons;
  std::size_t total = 0;
  for (const auto& [geometry, value] : source.read(wkbPolygon, "polygons", dem_crs)) {
    ValuedPolygon& valued = polygons.emplace_back();
    valued.value = value;
    for (const OGRLinearRing* ring : *geometry->toPolygon()) {
      std::vector<Vec3d> vertices = vertices_of(*ring, source, total);
      const bool is_closed = vertices.size() > 1 && vertices.front().x == vertices.back().x &&
                             vertices.front().y == vertices.back().y;
      if (is_closed) vertices.pop_back();
      valued.polygon.rings.push_back(std::move(vertices));
    }
    if (!geometry->IsValid()) {
      source.refuse("has an invalid polygon: " + source.errors().warning(),
                    "repair it, e.g. ogr2ogr -makevalid out.gpkg in.gpkg");
    }
  }
  return polygons;
}

std::vector<Polygon> read_polygons(const std::filesystem::path& file, const std::string& dem_crs,
                                   const std::string& key) {
  std::vector<Polygon> polygons;
  for (ValuedPolygon& valued : read_valued_polygons(file, dem_crs, key, "")) {
    polygons.push_back(std::move(valued.polygon));
  }
  return polygons;
}

}  // namespace sabo
