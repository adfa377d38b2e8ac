#include "terrain/hole_filling.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace sabo {
namespace {

/// One connected area without data.
struct Hole {
  std::vector<std::size_t> cells;
  bool is_at_border = false;
};

/// The area that holds `start`; its cells are marked as visited.
Hole hole_at(const Raster& raster, std::size_t start, std::vector<std::uint8_t>& visited) {
  const Grid& grid = raster.grid;
  Hole hole;
  hole.cells.push_back(start);
  visited[start] = 1;
  for (std::size_t next = 0; next < hole.cells.size(); ++next) {
    const int column = grid.column_at(hole.cells[next]);
    const int row = grid.row_at(hole.cells[next]);
    for (int down = -1; down <= 1; ++down) {
      for (int right = -1; right <= 1; ++right) {
        if (!grid.has_cell(column + right, row + down)) {
          hole.is_at_border = true;
          continue;
        }
        const std::size_t neighbour = grid.index(column + right, row + down);
        if (visited[neighbour] || !std::isnan(raster.values[neighbour])) continue;
        visited[neighbour] = 1;
        hole.cells.push_back(neighbour);
      }
    }
  }
  return hole;
}

/// Mean of the hole's rim, by which the solution starts.
double rim_mean(const Raster& raster, const std::vector<std::size_t>& cells) {
  double sum = 0;
  std::size_t count = 0;
  for (const std::size_t cell : cells) {
    for (const std::size_t neighbour :
         {cell - 1, cell + 1, cell - raster.grid.columns, cell + raster.grid.columns}) {
      if (std::isnan(raster.values[neighbour])) continue;
      sum += raster.values[neighbour];
      ++count;
    }
  }
  return sum / static_cast<double>(count);
}

/// Laplace's equation by successive over-relaxation; `cells` touch no border.
void fill(Raster& raster, const std::vector<std::size_t>& cells) {
  constexpr double tolerance = 1e-6;  // m
  const Grid& grid = raster.grid;
  const double mean = rim_mean(raster, cells);
  for (const std::size_t cell : cells) raster.values[cell] = mean;

  // The best factor for a square of as many cells; sweeps grow with its side.
  const double side = std::sqrt(static_cast<double>(cells.size()));
  const double relaxation = 2 / (1 + std::sin(std::numbers::pi / (side + 1)));
  const int most_sweeps = 200 + static_cast<int>(20 * side);
  const double weight_x = 1 / (grid.dx * grid.dx);
  const double weight_y = 1 / (grid.dy * grid.dy);
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    double largest_change = 0;
    for (const std::size_t cell : cells) {
      double* z = &raster.values[cell];
      const double balance =
          (weight_x * (z[-1] + z[1]) + weight_y * (z[-grid.columns] + z[grid.columns])) /
          (2 * (weight_x + weight_y));
      const double change = relaxation * (balance - *z);
      *z += change;
      largest_change = std::max(largest_change, std::abs(change));
    }
    if (largest_change < tolerance) return;
  }
}

}  // namespace

HoleReport fill_holes(Raster& raster, int largest_hole_cells) {
  HoleReport report;
  std::vector<std::uint8_t> visited(raster.values.size());
  for (std::size_t cell = 0; cell < raster.values.size(); ++cell) {
    if (visited[cell] || !std::isnan(raster.values[cell])) continue;
    const Hole hole = hole_at(raster, cell, visited);
    if (hole.is_at_border) {
      report.border_cells_left += hole.cells.size();
    } else if (static_cast<double>(hole.cells.size()) <= largest_hole_cells) {
      fill(raster, hole.cells);
      ++report.holes_filled;
      report.cells_filled += hole.cells.size();
    } else {
      ++report.holes_left;
      report.enclosed_cells_left += hole.cells.size();
    }
  }
  return report;
}

}  // namespace sabo
