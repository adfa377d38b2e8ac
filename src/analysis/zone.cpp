#include "analysis/zone.hpp"

#include <algorithm>
#include <cmath>

#include "terrain/cells_within.hpp"

namespace sabo {

Zone::Zone(const Raster& elevation, const std::vector<Polygon>& polygons)
    : cell_area_(elevation.grid.cell_area()), cells_(cells_within(elevation.grid, polygons)) {
  std::erase_if(cells_, [&](std::size_t cell) { return std::isnan(elevation.values[cell]); });
}

void Zone::add(double depth, double wet, ZoneDepth& zone) const {
  zone.volume += depth * cell_area_;
  zone.greatest = std::max(zone.greatest, depth);
  if (!(depth > wet)) return;
  zone.wet_area += cell_area_;
  zone.mean_wet += depth * cell_area_;  // a volume until finish()
}

void Zone::finish(ZoneDepth& zone) const {
  zone.mean_wet = zone.wet_area > 0 ? zone.mean_wet / zone.wet_area : 0;
  zone.mean_all = area() > 0 ? zone.volume / area() : 0;
}

}  // namespace sabo
