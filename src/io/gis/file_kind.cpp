#include "io/gis/file_kind.hpp"

#include <gdal_priv.h>

#include "io/gis/gdal_errors.hpp"

namespace sabo {

GisFileKind kind_of_gis_file(const std::filesystem::path& file) {
  const GdalErrors errors;
  const auto opens = [&](unsigned flags) {
    return GDALDatasetUniquePtr(GDALDataset::Open(file.c_str(), flags)) != nullptr;
  };
  if (opens(GDAL_OF_RASTER)) return GisFileKind::raster;
  return opens(GDAL_OF_VECTOR) ? GisFileKind::vectors : GisFileKind::unknown;
}

}  // namespace sabo
