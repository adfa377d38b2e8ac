#pragma once

#include <cstddef>
#include <vector>

#include "terrain/polyline.hpp"
#include "terrain/raster.hpp"

namespace sabo {

/// Depth of the flow in a zone; both means are of vertical depth.
struct ZoneDepth {
  double volume = 0;    ///< m3
  double wet_area = 0;  ///< m2, of cells deeper than wet_depth()
  double mean_wet = 0;  ///< over the wet cells, m; 0 without any
  double mean_all = 0;  ///< over the whole zone, m
  double greatest = 0;  ///< m
};

/// An area in which depth is measured: the cells whose centres lie in polygons.
class Zone {
 public:
  /// Cells where `elevation` is NaN are outside the domain and no part of the zone.
  Zone(const Raster& elevation, const std::vector<Polygon>& polygons);

  bool is_empty() const { return cells_.empty(); }
  double area() const { return static_cast<double>(cells_.size()) * cell_area_; }  ///< m2

  /// From a function that gives the depth of a cell by its index, m. Cells deeper than `wet` (m)
  /// are wet.
  template <class Depth>
  ZoneDepth measure(const Depth& depth, double wet) const {
    ZoneDepth zone;
    for (const std::size_t cell : cells_) add(depth(cell), wet, zone);
    finish(zone);
    return zone;
  }

 private:
  void add(double depth, double wet, ZoneDepth& zone) const;
  void finish(ZoneDepth& zone) const;

  double cell_area_;
  std::vector<std::size_t> cells_;
};

}  // namespace sabo
