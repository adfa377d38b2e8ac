#pragma once

#include <array>
#include <string>

#include "terrain/raster.hpp"

namespace sabo {

/// Rectangle of cells of a grid.
struct CellWindow {
  int column = 0;  ///< its north-west cell
  int row = 0;
  int columns = 0;
  int rows = 0;
};

/// The cells that touch [west, south, east, north], none of them outside of the grid; a window
/// along cell edges takes no further cells. May be empty.
CellWindow cells_touching(const Grid& grid, const std::array<double, 4>& bounds);

/// The same for terrain.crop. Throws CaseError there when the bounds are reversed or hold less than
/// 2 x 2 cells; `name` is that of the raster, for the message.
CellWindow crop_window(const Grid& grid, const std::array<double, 4>& crop,
                       const std::string& name);

/// The part of a grid.
Grid part_of(Grid grid, const CellWindow& window);

}  // namespace sabo
