#include "io/gis/read_fg_gml.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/gis/fg_gml_files.hpp"
#include "io/gis/raster_file.hpp"
#include "io/gis/round_length.hpp"

namespace sabo {
namespace {

constexpr const char* dem_key = "terrain.dem";
constexpr double metres_per_degree = 111'000;  // along a meridian

struct NamedTile {
  std::string name;
  FgGmlTile tile;
};

const char* datum_name(JapaneseDatum datum) {
  switch (datum) {
    case JapaneseDatum::jgd2000:
      return "JGD2000";
    case JapaneseDatum::jgd2011:
      return "JGD2011";
    case JapaneseDatum::jgd2024:
      return "JGD2024";
  }
  return "";
}

double nominal_size(const Grid& grid) { return round_length(grid.dy * metres_per_degree); }

// Corners have nine decimals of a degree, 1e-4 cells of 1 m.
void check_alike(const NamedTile& first, const NamedTile& other) {
  const Grid& a = first.tile.raster.grid;
  const Grid& b = other.tile.raster.grid;
  if (first.tile.datum != other.tile.datum) {
    throw CaseError(dem_key,
                    fmt::format("{} is in {}, {} in {}", other.name, datum_name(other.tile.datum),
                                first.name, datum_name(first.tile.datum)),
                    "give tiles of one datum; elevations of JGD2024 differ from those before");
  }
  constexpr double ratio = 1e-5;
  if (std::abs(b.dx - a.dx) > ratio * a.dx || std::abs(b.dy - a.dy) > ratio * a.dy) {
    throw CaseError(
        dem_key,
        fmt::format("{} has cells of {:.4g} x {:.4g} seconds, {} of {:.4g} x {:.4g}", other.name,
                    b.dx * 3600, b.dy * 3600, first.name, a.dx * 3600, a.dy * 3600),
        "give tiles of one cell size");
  }
  constexpr double slack = 0.05;  // cells
  const double columns = (b.west - a.west) / a.dx;
  const double rows = (b.north - a.north) / a.dy;
  if (std::abs(columns - std::round(columns)) > slack || std::abs(rows - std::round(rows)) > slack)
    throw CaseError(dem_key,
                    fmt::format("{} does not lie on the grid of {}", other.name, first.name),
                    "give tiles as GSI makes them");
}

std::vector<NamedTile> read_tiles(const std::filesystem::path& file) {
  std::vector<NamedTile> tiles;
  std::size_t cells = 0;
  for_each_fg_gml(file, [&](const std::string& name, const std::string& text) {
    tiles.push_back({name, parse_fg_gml(text, name)});
    cells += tiles.back().tile.raster.values.size();
    if (cells > RasterFile::max_cells) {
      throw CaseError(dem_key,
                      fmt::format("{} has tiles of more than {} cells in all", file.string(),
                                  RasterFile::max_cells),
                      "leave out those far from the flow");
    }
  });
  std::ranges::sort(tiles, {}, [](const NamedTile& tile) { return fg_gml_rank(tile.name); });
  for (const NamedTile& tile : tiles) check_alike(tiles.front(), tile);
  return tiles;
}

Grid common_grid(const std::vector<NamedTile>& tiles, const std::string& name) {
  Grid grid = tiles.front().tile.raster.grid;
  double east = grid.east();
  double south = grid.south();
  for (const NamedTile& row : tiles) {
    const Grid& own = row.tile.raster.grid;
    grid.west = std::min(grid.west, own.west);
    grid.north = std::max(grid.north, own.north);
    east = std::max(east, own.east());
    south = std::min(south, own.south());
  }
  const double columns = std::round((east - grid.west) / grid.dx);
  const double rows = std::round((grid.north - south) / grid.dy);
  if (columns * rows > static_cast<double>(RasterFile::max_cells)) {
    throw CaseError(dem_key,
                    fmt::format("{} has tiles so far apart that {:.0f} x {:.0f} cells cover them, "
                                "more than {} in all",
                                name, columns, rows, RasterFile::max_cells),
                    "leave out those far from the flow");
  }
  grid.columns = static_cast<int>(columns);
  grid.rows = static_cast<int>(rows);
  // Over many tiles the rounding of the corners matters less.
  grid.dx = (east - grid.west) / columns;
  grid.dy = (grid.north - south) / rows;
  return grid;
}

void place(const Raster& tile, Raster& whole) {
  const int first_column =
      static_cast<int>(std::round((tile.grid.west - whole.grid.west) / whole.grid.dx));
  const int first_row =
      static_cast<int>(std::round((whole.grid.north - tile.grid.north) / whole.grid.dy));
  for (int row = 0; row < tile.grid.rows; ++row) {
    for (int column = 0; column < tile.grid.columns; ++column) {
      const double value = tile.at(column, row);
      const bool is_inside = whole.grid.has_cell(first_column + column, first_row + row);
      if (!std::isnan(value) && is_inside) {
        whole.at(first_column + column, first_row + row) = value;
      }
    }
  }
}

std::string note_of(const std::vector<NamedTile>& tiles, double cell_size) {
  std::string note =
      fmt::format("{} tile{} of {:g} m, {}", tiles.size(), tiles.size() == 1 ? "" : "s", cell_size,
                  datum_name(tiles.front().tile.datum));
  std::vector<std::string> dates;
  for (const NamedTile& row : tiles) {
    if (!row.tile.date.empty()) dates.push_back(row.tile.date);
  }
  if (dates.empty()) return note;
  const auto [first, last] = std::ranges::minmax_element(dates);
  return note + (*first == *last ? ", date " + *first : ", dates " + *first + " to " + *last);
}

}  // namespace

FgGmlDem read_fg_gml(const std::filesystem::path& file) {
  std::vector<NamedTile> tiles = read_tiles(file);
  FgGmlDem dem;
  dem.datum = tiles.front().tile.datum;
  dem.cell_size = nominal_size(tiles.front().tile.raster.grid);
  dem.note = note_of(tiles, dem.cell_size);
  dem.raster = Raster(common_grid(tiles, file.string()), Raster::no_data);
  for (NamedTile& row : tiles) {
    const Raster tile = std::move(row.tile.raster);  // its memory goes as soon as it is placed
    place(tile, dem.raster);
  }
  return dem;
}

int geographic_code(JapaneseDatum datum) { return datum == JapaneseDatum::jgd2000 ? 4612 : 6668; }

int utm_code(JapaneseDatum datum, double longitude) {
  const int zone = static_cast<int>(std::floor((longitude + 180) / 6)) + 1;
  if (zone < 51 || zone > 55) {
    throw CaseError(
        "terrain.crs",
        fmt::format("the DEM lies in UTM zone {}, for which {} has no coordinate system", zone,
                    datum_name(datum)),
        "give a projected one in metres, e.g. \"EPSG:32656\"");
  }
  const int first = datum == JapaneseDatum::jgd2000 ? 3097 : 6688;  // zone 51
  return first + zone - 51;
}

}  // namespace sabo
