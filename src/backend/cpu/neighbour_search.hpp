#pragma once

#include <initializer_list>
#include <vector>

#include "backend/cpu/column_grid.hpp"
#include "backend/cpu/pair_list.hpp"
#include "backend/periodic.hpp"
#include "particles/particles.hpp"

namespace sabo {

/// Smallest box that holds all positions; zero when there are none.
void bounding_box(std::initializer_list<const std::vector<Vec3d>*> clouds, Vec3d& low, Vec3d& high);

/// Sorts particles by column and lists the pairs within a radius.
class NeighbourSearch {
 public:
  NeighbourSearch(const Periodic& periodic, double radius, int threads);

  /// Reorders both sets; the order depends on positions and ids alone.
  void sort(Particles& fluid, Particles& boundary);

  /// Fluid particles list fluid and boundary, boundary particles list fluid only. Indices count the
  /// fluid first. `has_neighbours` gets one entry per fluid particle.
  void fill(const std::vector<Vec3d>& fluid, const std::vector<Vec3d>& boundary, PairList& list,
            std::vector<char>& has_neighbours) const;

 private:
  void append_near(const ColumnGrid& grid, const std::vector<Vec3d>& cloud, const Vec3d& x,
                   std::uint32_t offset, std::uint32_t self,
                   std::vector<std::uint32_t>& list) const;

  Periodic periodic_;
  double radius_;
  int threads_;
  std::vector<Vec3d> shifts_;  // from a particle to its images that may have neighbours here
  ColumnGrid fluid_grid_;
  ColumnGrid boundary_grid_;
};

}  // namespace sabo
