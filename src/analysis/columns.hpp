#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "analysis/spreader.hpp"
#include "particles/particles.hpp"
#include "terrain/raster.hpp"

namespace sabo {

/// Depth above which a cell counts as wet, m: speed and pressure mean nothing where the edge of a
/// footprint leaves a film. Half a spacing (m) in flows finer than those on a map.
inline double wet_depth(double spacing) { return std::min(0.05, spacing / 2); }

/// What stands over each cell of the DEM at one moment. Depth is vertical: the volume over a cell
/// (mass / reference density, see Spreader) by its area, so that the sum of depth x area is the
/// particles' volume to rounding. An update costs as much as the particles and their footprints,
/// whatever the grid.
class Columns {
 public:
  /// Cells where `elevation` is NaN are outside the domain. `spacing` in m, density in kg/m3.
  Columns(const Raster& elevation, double spacing, double reference_density);

  /// Takes in the particles as they are.
  void update(const Particles& particles);

  /// Cells that hold volume, each once.
  const std::vector<std::size_t>& touched() const { return touched_; }
  double depth(std::size_t cell) const { return volume_[cell] / spreader_.grid().cell_area(); }
  /// Above which a cell is wet, m.
  double threshold() const { return wet_depth_; }
  bool is_wet(std::size_t cell) const { return depth(cell) > wet_depth_; }
  /// Mean by mass, m/s; of a touched cell only.
  double speed(std::size_t cell) const { return transport_[cell] / volume_[cell]; }
  /// Greatest in the column, Pa, not negative.
  double pressure(std::size_t cell) const { return pressure_[cell]; }

  // Rasters, NaN outside the domain; speed and pressure are 0 where the cell is not wet.
  Raster depth() const;     ///< m
  Raster speed() const;     ///< m/s
  Raster pressure() const;  ///< Pa

  /// Values of all cells as a raster, NaN outside the domain.
  Raster masked(const std::vector<double>& values) const;

 private:
  template <class Value>
  Raster wet(const Value& value) const;

  Spreader spreader_;
  double reference_density_;
  double wet_depth_;
  std::vector<double> volume_;     // m3
  std::vector<double> transport_;  // volume x speed, m4/s
  std::vector<double> pressure_;   // Pa
  std::vector<std::size_t> touched_;
};

}  // namespace sabo
