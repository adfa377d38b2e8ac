#pragma once

#include <filesystem>
#include <string>

#include "io/gis/fg_gml.hpp"

namespace sabo {

/// Tiles of the GSI base map, put together.
struct FgGmlDem {
  Raster raster;  ///< elevations, m, in degrees: x is the longitude
  JapaneseDatum datum = JapaneseDatum::jgd2011;
  double cell_size = 0;  ///< the name of the mesh, m: 1, 5 or 10
  std::string note;      ///< e.g. "2 tiles of 5 m, JGD2011, dates 2016-10-01 to 2021-03-04"
};

/// Reads the tiles of an .xml file, a folder or a .zip (fg_gml_files.hpp). Where tiles overlap, the
/// better survey counts where it has data (DEM5A before DEM5B before DEM5C), among equal ones the
/// later file name, that is the newer date. Throws CaseError at terrain.dem: whatever is wrong with
/// a tile, tiles of different cell size or datum, tiles too far apart.
FgGmlDem read_fg_gml(const std::filesystem::path& file);

/// EPSG code of the datum in degrees: 4612 (JGD2000) or 6668 (JGD2011, and the places of JGD2024).
int geographic_code(JapaneseDatum datum);

/// EPSG code of the datum in the UTM zone of a longitude, degrees. Throws CaseError at terrain.crs
/// outside of the zones 51 to 55, for which there are codes.
int utm_code(JapaneseDatum datum, double longitude);

}  // namespace sabo
