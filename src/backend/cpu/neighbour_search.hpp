#pragma once

#include <initializer_list>
#include <vector>

#include "backend/cpu/column_grid.hpp"
#include "backend/cpu/pair_list.hpp"
#include "backend/cpu/pair_sweeps.hpp"
#include "backend/periodic.hpp"
#include "particles/particles.hpp"

namespace sabo {

/// Smallest box that holds all positions; zero when there are none.
void bounding_box(std::initializer_list<const std::vector<Vec3d>*> clouds, Vec3d& low, Vec3d& high);

/// Sorts particles by column and lists the pairs within a radius.
class NeighbourSearch {
 public:
  NeighbourSearch(const Periodic& periodic, double radius, int threads,
                  const PairSweeps& sweeps = best_pair_sweeps());

  /// Reorders both sets; the order depends on positions and ids alone.
  void sort(Particles& fluid, Particles& boundary);

  /// Fluid particles list fluid and boundary, boundary particles list fluid only. Indices count the
  /// fluid first. `has_neighbours` gets one entry per fluid particle.
  void fill(const std::vector<Vec3d>& fluid, const std::vector<Vec3d>& boundary, PairList& list,
            std::vector<char>& has_neighbours) const;

 private:
  /// Positions relative to the middle of all, in the precision of the sweeps; the skin of the list
  /// is many times what that loses.
  struct Points {
    std::vector<float> x, y, z;
    Points(const std::vector<Vec3d>& positions, const Vec3d& centre, int threads);
  };
  /// A sorted set to be searched.
  struct Cloud {
    const ColumnGrid& grid;
    const std::vector<Vec3d>& positions;
    Points points;
    std::uint32_t offset;  ///< index of its first particle
  };
  /// Where a search in a cloud stands, one for each image of the places.
  std::vector<ColumnGrid::Runs> start(const Cloud& cloud) const;
  /// Returns how many it appended.
  std::size_t append_near(const Cloud& cloud, std::vector<ColumnGrid::Runs>& runs,
                          const Vec3d& centre, const Vec3d& x, std::uint32_t self,
                          PairList::Chunk& list) const;

  Periodic periodic_;
  double radius_;
  int threads_;
  const PairSweeps& sweeps_;
  std::vector<Vec3d> shifts_;  // from a particle to its images that may have neighbours here
  ColumnGrid fluid_grid_;
  ColumnGrid boundary_grid_;
};

}  // namespace sabo
