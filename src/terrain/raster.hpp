#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "math/vec3.hpp"

namespace sabo {

/// North-up grid of cells; column 0, row 0 is the north-west cell, as in GDAL.
struct Grid {
  int columns = 0;
  int rows = 0;
  double west = 0;   ///< x of the western edge, m
  double north = 0;  ///< y of the northern edge, m
  double dx = 1;     ///< cell width, m, positive
  double dy = 1;     ///< cell height, m, positive

  std::size_t size() const { return static_cast<std::size_t>(columns) * rows; }
  double east() const { return west + columns * dx; }
  double south() const { return north - rows * dy; }
  /// Centre of a cell.
  double x_of(int column) const { return west + (column + 0.5) * dx; }
  double y_of(int row) const { return north - (row + 0.5) * dy; }
  /// Cell that holds a coordinate; may lie outside [0, columns) or [0, rows).
  int column_of(double x) const { return static_cast<int>(std::floor((x - west) / dx)); }
  int row_of(double y) const { return static_cast<int>(std::floor((north - y) / dy)); }
  bool has_cell(int column, int row) const {
    return column >= 0 && column < columns && row >= 0 && row < rows;
  }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * columns + column;
  }
  /// Column and row of the cell that has an index.
  int column_at(std::size_t cell) const {
    return static_cast<int>(cell % static_cast<std::size_t>(columns));
  }
  int row_at(std::size_t cell) const {
    return static_cast<int>(cell / static_cast<std::size_t>(columns));
  }
  double cell_area() const { return dx * dy; }
  friend bool operator==(const Grid&, const Grid&) = default;
};

/// Values on a grid, row by row from the north-west; NaN where there is no data.
struct Raster {
  static constexpr double no_data = std::numeric_limits<double>::quiet_NaN();

  Grid grid;
  std::vector<double> values;

  Raster() = default;
  explicit Raster(const Grid& g, double value = 0) : grid(g), values(g.size(), value) {}

  double& at(int column, int row) { return values[grid.index(column, row)]; }
  double at(int column, int row) const { return values[grid.index(column, row)]; }
};

/// The solver frame: CRS coordinates minus a whole-number origin, so that small numbers keep their
/// digits. z is not shifted.
struct Frame {
  double origin_x = 0;
  double origin_y = 0;
  std::string crs;  ///< WKT of the DEM's coordinate system; "" for a DEM without one

  /// Where it begins in coordinates of the CRS, m.
  Vec3d origin() const { return {origin_x, origin_y, 0}; }
};

}  // namespace sabo
