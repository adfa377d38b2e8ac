#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "base/error.hpp"
#include "io/gis/fg_gml.hpp"

/// Whatever the bytes: the reader refuses them, or gives a tile that can be worked with.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    const sabo::FgGmlTile tile = sabo::parse_fg_gml(text, "tile.xml");
    const sabo::Raster& raster = tile.raster;
    bool is_sound = raster.grid.columns > 0 && raster.grid.rows > 0 && raster.grid.dx > 0 &&
                    raster.grid.dy > 0 && raster.values.size() == raster.grid.size() &&
                    raster.values.size() <= sabo::max_tile_cells;
    for (const double value : raster.values) is_sound = is_sound && !std::isinf(value);
    if (!is_sound) __builtin_trap();
  } catch (const sabo::CaseError&) {
  }
  return 0;
}
