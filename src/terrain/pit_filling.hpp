#pragma once

#include <cstddef>

#include "terrain/raster.hpp"

namespace sabo {

/// Whether a cell lies at the border of the raster or of an area without data.
bool is_at_border(const Raster& raster, std::size_t cell);

/// The lowest surface at or above `elevation` on which the way down from every cell leads to the
/// border or to the lowest cell of all: priority flood with a rise of 1e-9 m per cell in flats
/// (Barnes, Lehman & Mulla 2014, Computers & Geosciences 62, algorithm 3).
Raster pits_filled(const Raster& elevation);

}  // namespace sabo
