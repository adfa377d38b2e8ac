#include "io/gis/class_map.hpp"

#include <cmath>
#include <memory>
#include <system_error>

#include <cpl_string.h>
#include <fmt/format.h>
#include <gdal_alg.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include "base/error.hpp"
#include "io/gis/gdal_errors.hpp"
#include "io/gis/georeference.hpp"
#include "io/gis/partial_file.hpp"

namespace sabo {
namespace {

constexpr int max_number = 255;

std::vector<GByte> bytes_of(const Raster& classes) {
  std::vector<GByte> bytes(classes.values.size(), 0);
  for (std::size_t cell = 0; cell < bytes.size(); ++cell) {
    const double value = classes.values[cell];
    if (std::isnan(value)) continue;
    if (!(value >= 1 && value <= max_number) || value != std::round(value))
      throw RunError(fmt::format("{} is not the number of a class", value));
    bytes[cell] = static_cast<GByte>(value);
  }
  return bytes;
}

bool write_bytes(GDALRasterBand& band, const Grid& grid, std::vector<GByte>& bytes) {
  return band.RasterIO(GF_Write, 0, 0, grid.columns, grid.rows, bytes.data(), grid.columns,
                       grid.rows, GDT_Byte, 0, 0, nullptr) == CE_None;
}

void describe(GDALDataset& data, const std::vector<RasterClass>& names,
              const std::string& description) {
  GDALRasterBand& band = *data.GetRasterBand(1);
  GDALColorTable colours;
  const GDALColorEntry clear{255, 255, 255, 0};
  colours.SetColorEntry(0, &clear);
  std::vector<std::string> labels{"none"};
  for (const RasterClass& name : names) {
    const auto number = static_cast<std::size_t>(name.number);
    const GDALColorEntry entry{name.colour[0], name.colour[1], name.colour[2], 255};
    colours.SetColorEntry(name.number, &entry);
    if (labels.size() <= number) labels.resize(number + 1);
    labels[number] = name.label;
    data.SetMetadataItem(fmt::format("CLASS_{}", number).c_str(), name.label.c_str());
  }
  band.SetColorTable(&colours);
  band.SetNoDataValue(0);
  band.SetDescription(description.c_str());
  CPLStringList list;
  for (const std::string& label : labels) list.AddString(label.c_str());
  band.SetCategoryNames(list.List());
}

// Names of categories are in a file of their own beside the GeoTIFF.
void commit(PartialFile& partial, const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::path side = partial.path().string() + ".aux.xml";
  partial.commit();
  if (!std::filesystem::exists(side, error)) return;  // GDAL was told to write none
  std::filesystem::rename(side, file.string() + ".aux.xml", error);
  if (error)
    throw RunError(fmt::format("cannot write {}.aux.xml: {}", file.string(), error.message()));
}

// The rings of what OGR gives, without the repeated first vertex.
Polygon polygon_of(const OGRPolygon& from) {
  Polygon polygon;
  for (const OGRLinearRing* ring : from) {
    std::vector<Vec3d> vertices;
    for (int k = 0; k + 1 < ring->getNumPoints(); ++k)
      vertices.push_back({ring->getX(k), ring->getY(k), 0});
    polygon.rings.push_back(std::move(vertices));
  }
  return polygon;
}

}  // namespace

void write_class_raster(const std::filesystem::path& file, const Raster& classes,
                        const std::vector<RasterClass>& names, const std::string& crs_wkt,
                        const std::string& description) {
  const GdalErrors errors;
  std::vector<GByte> bytes = bytes_of(classes);
  const Grid& grid = classes.grid;
  PartialFile partial(file);
  CPLStringList options;
  options.SetNameValue("COMPRESS", "DEFLATE");
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  GDALDatasetUniquePtr data(
      driver->Create(partial.path().c_str(), grid.columns, grid.rows, 1, GDT_Byte, options.List()));
  bool is_written = data != nullptr;
  if (is_written) {
    georeference(*data, grid, crs_wkt);
    describe(*data, names, description);
    is_written = write_bytes(*data->GetRasterBand(1), grid, bytes);
    data.reset();
  }
  if (!is_written || errors.failed()) {
    throw RunError(
        fmt::format("cannot write {}: {}", file.string(), errors.failure("the disk may be full")));
  }
  commit(partial, file);
}

std::vector<ClassPolygon> polygons_of(const Raster& classes) {
  const GdalErrors errors;
  std::vector<GByte> bytes = bytes_of(classes);
  const Grid& grid = classes.grid;
  GDALDriverManager& drivers = *GetGDALDriverManager();
  GDALDatasetUniquePtr raster(
      drivers.GetDriverByName("MEM")->Create("", grid.columns, grid.rows, 1, GDT_Byte, nullptr));
  GDALDatasetUniquePtr vectors(
      drivers.GetDriverByName("Memory")->Create("", 0, 0, 0, GDT_Unknown, nullptr));
  OGRLayer* layer =
      vectors ? vectors->CreateLayer("classes", nullptr, wkbPolygon, nullptr) : nullptr;
  OGRFieldDefn field("number", OFTInteger);
  bool is_done = raster && layer && layer->CreateField(&field) == OGRERR_NONE;
  if (is_done) {
    georeference(*raster, grid, "");
    GDALRasterBand& band = *raster->GetRasterBand(1);
    band.SetNoDataValue(0);
    is_done = write_bytes(band, grid, bytes) &&
              GDALPolygonize(GDALRasterBand::ToHandle(&band),
                             GDALRasterBand::ToHandle(band.GetMaskBand()),
                             OGRLayer::ToHandle(layer), 0, nullptr, nullptr, nullptr) == CE_None;
  }
  if (!is_done || errors.failed())
    throw RunError("cannot make outlines: " + errors.failure("GDAL gave no reason"));
  std::vector<ClassPolygon> polygons;
  for (const auto& feature : *layer) {
    const OGRGeometry* geometry = feature->GetGeometryRef();
    if (!geometry || wkbFlatten(geometry->getGeometryType()) != wkbPolygon) continue;
    polygons.push_back({feature->GetFieldAsInteger(0), polygon_of(*geometry->toPolygon())});
  }
  return polygons;
}

}  // namespace sabo
