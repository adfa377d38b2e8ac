#pragma once

#include "backend/device/column_search.hpp"

// Whether the pairs of a list may have missed one since it was made, by the argument of
// backend/cpu/list_age.hpp: it takes a relative motion of the skin to bring in a pair that is not
// listed, and the motion that places near to each other share does not count.

namespace sabo {

/// Box of the ways that particles have gone since the list was made.
struct FindWay {
  const Vec3d* position;
  const Vec3d* start;
  SABO_HD void operator()(std::size_t i, CloudBox& sum) const {
    const Vec3d way = position[i] - start[i];
    sum.join({way, way});
  }
};

/// The same for each column.
struct FindColumnWays {
  FindWay way;
  const std::uint32_t* first;
  CloudBox* ways;
  SABO_HD void operator()(std::size_t column) const {
    CloudBox box;
    for (std::uint32_t i = first[column]; i < first[column + 1]; ++i) way(i, box);
    ways[column] = box;
  }
};

/// Greatest of a length, squared. A NaN counts as great.
struct Longest {
  double square = 0;
  SABO_HD void join(const Longest& other) {
    if (square == square && !(other.square <= square)) square = other.square;
  }
};

/// The longest way of a particle.
struct FindLongestWay {
  const Vec3d* position;
  const Vec3d* start;
  SABO_HD void operator()(std::size_t i, Longest& sum) const {
    const Vec3d way = position[i] - start[i];
    sum.join({dot(way, way)});
  }
};

/// The longest way of a particle against another one that it could have met, within a column and
/// its neighbours: columns are as wide as the list's radius, of which the skin is less than half,
/// so that two that meet after moving by the skin at most started in three columns side by side.
struct FindLongestRelativeWay {
  ColumnLattice lattice;
  const CloudBox* ways;
  SABO_HD void operator()(std::size_t column, Longest& sum) const {
    const auto ix = static_cast<std::int64_t>(column) % lattice.nx;
    const auto iy = static_cast<std::int64_t>(column) / lattice.nx;
    CloudBox box;
    for (std::int64_t y = iy - 1; y <= iy + 1; ++y)
      for (std::int64_t x = ix - 1; x <= ix + 1; ++x)
        if (x >= 0 && y >= 0 && x < lattice.nx && y < lattice.ny)
          box.join(ways[y * lattice.nx + x]);
    if (box.is_empty()) return;
    const Vec3d diagonal = box.high - box.low;
    sum.join({dot(diagonal, diagonal)});
  }
};

}  // namespace sabo
