#pragma once

#include <cstddef>

#include "terrain/raster.hpp"

namespace sabo {

/// What became of the areas without data. Cells that share an edge or a corner are one area.
struct HoleReport {
  int holes_filled = 0;
  std::size_t cells_filled = 0;
  int holes_left = 0;                   ///< enclosed, but too large
  std::size_t enclosed_cells_left = 0;  ///< in these
  std::size_t border_cells_left = 0;    ///< in areas that reach the border of the raster
};

/// Fills each enclosed area without data of at most `largest_hole_cells` cells with the smooth
/// surface (Laplace's equation) over its rim: between the rim's lowest and highest values, and on a
/// plane the plane. All other cells are left as they are.
HoleReport fill_holes(Raster& raster, int largest_hole_cells);

}  // namespace sabo
