#include "terrain/terrain_edit.hpp"

#include <algorithm>
#include <cmath>

#include "terrain/cells_within.hpp"

namespace sabo {
namespace {

/// Sums of a row from its western end, so that a chord of a circle costs two look-ups.
struct RowSums {
  std::vector<double> height;  // of the cells before
  std::vector<int> count;      // of cells with data before
};

std::vector<RowSums> row_sums(const Raster& ground) {
  const Grid& grid = ground.grid;
  std::vector<RowSums> rows(grid.rows);
  for (int row = 0; row < grid.rows; ++row) {
    rows[row].height.assign(1, 0);
    rows[row].count.assign(1, 0);
    for (int column = 0; column < grid.columns; ++column) {
      const double z = ground.at(column, row);
      rows[row].height.push_back(rows[row].height.back() + (std::isnan(z) ? 0 : z));
      rows[row].count.push_back(rows[row].count.back() + (std::isnan(z) ? 0 : 1));
    }
  }
  return rows;
}

double mean_around(const Grid& grid, const std::vector<RowSums>& rows, std::size_t cell,
                   double radius) {
  const int column = grid.column_at(cell);
  const int row = grid.row_at(cell);
  constexpr double rounding = 1e-9;  // cells: a neighbour at the radius itself counts
  const auto cells = [](double distance, int count) {
    return static_cast<int>(std::min(distance + rounding, static_cast<double>(count)));
  };
  const int reach = cells(radius / grid.dy, grid.rows);
  double height = 0;
  int count = 0;
  for (int r = std::max(0, row - reach); r <= std::min(grid.rows - 1, row + reach); ++r) {
    const double away = (r - row) * grid.dy;
    const double chord2 = std::max(0.0, radius * radius - away * away);
    const int half = cells(std::sqrt(chord2) / grid.dx, grid.columns);
    const int first = std::max(0, column - half);
    const int end = std::min(grid.columns, column + half + 1);
    height += rows[r].height[end] - rows[r].height[first];
    count += rows[r].count[end] - rows[r].count[first];
  }
  return height / count;  // the cell itself has data
}

void change_cell(double& z, double changed, double cell_area, EditReport& report) {
  const double rise = changed - z;
  (rise > 0 ? report.fill : report.cut) += std::abs(rise) * cell_area;
  report.greatest = std::max(report.greatest, std::abs(rise));
  ++report.cells;
  z = changed;
}

}  // namespace

EditReport apply(const TerrainEdit& edit, Raster& ground) {
  EditReport report;
  report.name = edit.name;
  const std::vector<std::size_t> cells = cells_within(ground.grid, edit.polygons);
  const auto change = [&](const auto& changed) {
    for (const std::size_t cell : cells) {
      double& z = ground.values[cell];
      if (!std::isnan(z)) change_cell(z, changed(cell, z), ground.grid.cell_area(), report);
    }
  };
  if (const auto* set = std::get_if<SetElevation>(&edit.change)) {
    change([&](std::size_t, double) { return set->elevation; });
  } else if (const auto* shift = std::get_if<ShiftElevation>(&edit.change)) {
    change([&](std::size_t, double z) { return z + shift->by; });
  } else if (const auto* smooth = std::get_if<SmoothElevation>(&edit.change)) {
    const std::vector<RowSums> rows = row_sums(ground);
    change([&](std::size_t cell, double) {
      return mean_around(ground.grid, rows, cell, smooth->radius);
    });
  }
  return report;
}

}  // namespace sabo
