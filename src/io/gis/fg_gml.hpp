#pragma once

#include <string>

#include "terrain/raster.hpp"

namespace sabo {

/// What the coordinates of Japan refer to. JGD2024 has the places of JGD2011, but other elevations.
enum class JapaneseDatum { jgd2000, jgd2011, jgd2024 };

/// One tile of the elevation model of GSI's base map (FG-GML, "JPGIS (GML)").
struct FgGmlTile {
  Raster raster;  ///< elevations, m, on a grid in degrees: x is the longitude, y the latitude
  JapaneseDatum datum = JapaneseDatum::jgd2011;
  std::string date;  ///< of the making, "2016-10-01"; "" when the file does not say
};

/// Largest tile that is read; those of 2026 have 1125 x 750 cells.
constexpr std::size_t max_tile_cells = 4'000'000;

/// Reads the text of a tile. Cells before the start point, after the end of the list, of the kind
/// "no data" and of -9999 m (sea, and water that was not measured) become NaN; all other kinds keep
/// their elevation. The encoding does not matter. `name` is that of the file, for messages. Throws
/// CaseError at terrain.dem: no XML, no FG-GML of elevations, an element missing, corners reversed,
/// another order of the values, more values than cells, a value that is no number, a tile too
/// large.
FgGmlTile parse_fg_gml(const std::string& text, const std::string& name);

}  // namespace sabo
