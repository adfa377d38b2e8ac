#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "backend/cpu/index_run.hpp"
#include "math/vec3.hpp"

namespace sabo {

/// Square columns in plan over a cloud of particles; within a column particles stand in order of
/// height. A valley is wide and shallow: columns cost memory by its plan area only, and a range of
/// heights within a column is found by bisection.
class ColumnGrid {
 public:
  /// Lays columns of the given width over the box [low, high] in plan.
  ColumnGrid(const Vec3d& low, const Vec3d& high, double width);
  ColumnGrid() = default;

  /// Order that sorts the positions by column, height and id: the same for any number of threads.
  std::vector<std::uint32_t> sorted_order(const std::vector<Vec3d>& position,
                                          const std::vector<std::uint32_t>& id, int threads);

  /// The particles near one place after another, see below.
  class Runs;

 private:
  std::int64_t lattice(double x) const { return static_cast<std::int64_t>(std::floor(x / width_)); }

  double width_ = 1;
  std::int64_t west_ = 0;  // number of the first column; columns of all grids stand on one lattice
  std::int64_t south_ = 0;
  int nx_ = 0;
  int ny_ = 0;
  std::vector<std::uint32_t> first_;  // nx ny + 1
};

/// Runs of particles near a place: one of each column around it, cut to heights within about a
/// radius that is at most the width of the columns. Places that come in the order of a grid with
/// the same width, column by column from below, find the next runs beside the last ones.
class ColumnGrid::Runs {
 public:
  /// Positions must be those of the grid's last sorted_order(), in that order.
  Runs(const ColumnGrid& grid, const std::vector<Vec3d>& position, double radius)
      : grid_(grid), position_(position), radius_(radius) {}

  /// Finds runs that hold all particles near x, and a few more.
  void move_to(const Vec3d& x);

  int count() const { return count_; }
  const IndexRun* runs() const { return runs_; }
  /// Particles in all runs.
  std::size_t size() const;

 private:
  void enter(std::int64_t column_x, std::int64_t column_y, double z);

  const ColumnGrid& grid_;
  const std::vector<Vec3d>& position_;
  double radius_;
  std::int64_t column_x_ = 0, column_y_ = 0;
  double low_ = 0;  // heights that the runs are good for
  double high_ = 0;
  bool is_inside_ = false;  // whether the runs belong to the column and heights above
  int count_ = 0;
  IndexRun runs_[9];
  std::uint32_t end_[9];  // of the columns
};

}  // namespace sabo
