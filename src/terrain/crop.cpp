#include "terrain/crop.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>

#include "base/error.hpp"

namespace sabo {
namespace {

/// Cells [first, last) of one axis.
struct Run {
  int first = 0;
  int last = 0;
  int count() const { return last - first; }
};

/// Cells that touch [low, high], in cells from the raster's edge; a window on a cell's edge, to
/// rounding, does not touch the cell beyond it.
Run cells_touching(double low, double high, int count) {
  constexpr double rounding = 1e-6;
  const auto kept = [&](double cell) {
    return static_cast<int>(std::clamp(cell, 0.0, 1.0 * count));
  };
  return {kept(std::floor(low + rounding)), kept(std::ceil(high - rounding))};
}

std::string extent_of(const Grid& grid) {
  std::ostringstream text;
  text.precision(10);
  text << "x " << grid.west << " to " << grid.east() << ", y " << grid.south() << " to "
       << grid.north;
  return text.str();
}

}  // namespace

Raster cropped(const Raster& raster, double west, double south, double east, double north) {
  const Grid& grid = raster.grid;
  if (!(west < east && south < north)) {
    throw CaseError("terrain.crop", "the window is empty",
                    "give [west, south, east, north] with west < east and south < north");
  }
  const Run columns =
      cells_touching((west - grid.west) / grid.dx, (east - grid.west) / grid.dx, grid.columns);
  const Run rows =
      cells_touching((grid.north - north) / grid.dy, (grid.north - south) / grid.dy, grid.rows);
  if (columns.count() < 2 || rows.count() < 2) {
    const bool misses = columns.count() < 1 || rows.count() < 1;
    throw CaseError("terrain.crop",
                    misses ? "the window lies outside the DEM"
                           : "the window leaves fewer than 2 x 2 cells of the DEM",
                    "choose a window within " + extent_of(grid));
  }

  Grid window = grid;
  window.columns = columns.count();
  window.rows = rows.count();
  window.west = grid.west + columns.first * grid.dx;
  window.north = grid.north - rows.first * grid.dy;
  Raster result(window);
  for (int row = 0; row < window.rows; ++row) {
    const auto from = raster.values.begin() +
                      static_cast<std::ptrdiff_t>(grid.index(columns.first, rows.first + row));
    std::copy_n(from, window.columns,
                result.values.begin() + static_cast<std::ptrdiff_t>(window.index(0, row)));
  }
  return result;
}

}  // namespace sabo
