#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "backend/device/pair_rows.hpp"
#include "backend/record_packer.hpp"
#include "backend/sweeps/flow_sums.hpp"
#include "base/bisect.hpp"
#include "math/scalar.hpp"

// Square columns in plan over a set of particles, as those of backend/cpu/column_grid.hpp: a valley
// is wide and shallow. Within a column particles stand in order of height, so that a key of both
// sorts them, and the particles near a place are runs that bisection finds.

namespace sabo {

struct CloudBox {
  Vec3d low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  SABO_HD void join(const CloudBox& b) {
    low = {smaller(b.low.x, low.x), smaller(b.low.y, low.y), smaller(b.low.z, low.z)};
    high = {larger(b.high.x, high.x), larger(b.high.y, high.y), larger(b.high.z, high.z)};
  }
  SABO_HD bool is_empty() const { return low.x > high.x; }
};
struct FindBox {
  const Vec3d* position;
  SABO_HD void operator()(std::size_t i, CloudBox& sum) const {
    sum.join({position[i], position[i]});
  }
};

/// Which column a place is in; columns of all sets stand on one lattice.
struct ColumnLattice {
  double width = 1;  ///< m
  std::int64_t west = 0, south = 0;
  std::int64_t nx = 0, ny = 0;

  ColumnLattice() = default;
  ColumnLattice(const CloudBox& box, double column_width) : width(column_width) {
    if (box.is_empty()) return;
    west = number(box.low.x);
    south = number(box.low.y);
    nx = number(box.high.x) - west + 1;
    ny = number(box.high.y) - south + 1;
  }
  SABO_HD std::int64_t number(double x) const {
    return static_cast<std::int64_t>(std::floor(x / width));
  }
  std::size_t columns() const { return static_cast<std::size_t>(nx * ny); }
  /// Of a particle of the set.
  SABO_HD std::uint64_t column(const Vec3d& x) const {
    const std::int64_t ix = std::clamp<std::int64_t>(number(x.x) - west, 0, nx - 1);
    const std::int64_t iy = std::clamp<std::int64_t>(number(x.y) - south, 0, ny - 1);
    return static_cast<std::uint64_t>(iy * nx + ix);
  }
};

/// Column above, height below.
struct MakeKey {
  ColumnLattice lattice;
  RecordPacker pack;
  const Vec3d* position;
  std::uint64_t* keys;
  std::uint32_t* order;
  SABO_HD void operator()(std::size_t i) const {
    const auto height = static_cast<std::uint32_t>(pack.place(position[i]).z) ^ 0x80000000u;
    keys[i] = lattice.column(position[i]) << 32 | height;
    order[i] = static_cast<std::uint32_t>(i);
  }
};

/// First particle of each column, and the end of the last.
struct FindColumn {
  const std::uint64_t* keys;
  std::size_t count;
  std::uint32_t* first;
  SABO_HD void operator()(std::size_t column) const {
    const std::uint64_t wanted = static_cast<std::uint64_t>(column) << 32;
    first[column] = static_cast<std::uint32_t>(
        bisect(std::size_t{0}, count, [&](std::size_t k) { return keys[k] < wanted; }));
  }
};

struct MakePlace {
  RecordPacker pack;
  const Vec3d* position;
  IntegerPlace* places;
  SABO_HD void operator()(std::size_t i) const { places[i] = pack.place(position[i]); }
};

/// a - b, exact while it fits.
SABO_HD inline std::int32_t difference(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b));
}

/// A sorted set to be searched.
struct ColumnSet {
  ColumnLattice lattice;
  const std::uint32_t* first;
  const IntegerPlace* places;
  std::uint32_t offset;  ///< index of its first particle among all

  /// Calls f(index) for each particle within the radius of x, whose place in integers is `at`.
  template <class F>
  SABO_HD void near(const Vec3d& x, const IntegerPlace& at, float unit, double radius,
                    const F& f) const {
    const std::int64_t cx = lattice.number(x.x) - lattice.west;
    const std::int64_t cy = lattice.number(x.y) - lattice.south;
    const auto reach = static_cast<std::int32_t>(radius / unit) + 1;
    const float radius2 = static_cast<float>(radius * radius);
    for (std::int64_t iy = cy - 1; iy <= cy + 1; ++iy)
      for (std::int64_t ix = cx - 1; ix <= cx + 1; ++ix) {
        if (ix < 0 || iy < 0 || ix >= lattice.nx || iy >= lattice.ny) continue;
        const std::uint32_t* bounds = first + iy * lattice.nx + ix;
        const std::uint32_t end = bounds[1];
        for (std::uint32_t k = above(bounds[0], end, at.z - reach); k < end; ++k) {
          const IntegerPlace& other = places[k];
          const std::int32_t up = difference(other.z, at.z);
          if (up > reach) break;
          const Vec3f d = unit * Vec3f{float(difference(other.x, at.x)),
                                       float(difference(other.y, at.y)), float(up)};
          if (square_of(d) < radius2) f(offset + k);
        }
      }
  }

 private:
  /// With the same bits wherever it is compiled in: pairs are counted by one kernel and written by
  /// another, into just as much room.
  SABO_HD static float square_of(const Vec3f& d) {
#ifdef __CUDA_ARCH__
    return __fmaf_rn(d.x, d.x, __fmaf_rn(d.y, d.y, __fmul_rn(d.z, d.z)));
#else
    return dot(d, d);
#endif
  }

  /// First of [low, high) that is not below a height.
  SABO_HD std::uint32_t above(std::uint32_t low, std::uint32_t high, std::int32_t height) const {
    return bisect(low, high, [&](std::uint32_t k) { return places[k].z < height; });
  }
};

/// From a particle to its images that may have neighbours here.
struct Images {
  Vec3d shift[27];
  int count = 0;

  explicit Images(const Periodic& periodic) {
    const auto reach = [&](int axis) { return periodic.on(axis) ? 1 : 0; };
    for (int a = -reach(0); a <= reach(0); ++a)
      for (int b = -reach(1); b <= reach(1); ++b)
        for (int c = -reach(2); c <= reach(2); ++c)
          shift[count++] = double(a) * periodic.period[0] + double(b) * periodic.period[1] +
                           double(c) * periodic.period[2];
  }
};

/// What both passes of the search know.
struct PairSearch {
  ColumnSet fluid, boundary;
  std::size_t fluid_count;
  const Vec3d* fluid_position;
  const Vec3d* boundary_position;
  RecordPacker pack;
  float unit;
  double radius;
  Images images;

  /// Calls f(j) for the neighbours of particle i in one of the sets.
  template <class F>
  SABO_HD void near(const ColumnSet& set, std::size_t i, const F& f) const {
    const Vec3d& x = i < fluid_count ? fluid_position[i] : boundary_position[i - fluid_count];
    for (int k = 0; k < images.count; ++k) {
      const Vec3d image = x + images.shift[k];
      set.near(image, pack.place(image), unit, radius, [&](std::uint32_t j) {
        if (j != i) f(j);
      });
    }
  }
};

struct CountPairs {
  PairSearch search;
  std::uint32_t* fluid;
  std::uint32_t* count;
  char* has_neighbours;
  SABO_HD void operator()(std::size_t i) const {
    std::uint32_t near = 0;
    const auto add = [&](std::uint32_t) { ++near; };
    search.near(search.fluid, i, add);
    fluid[i] = near;
    if (i < search.fluid_count) search.near(search.boundary, i, add);
    count[i] = near;
    if (i < search.fluid_count) has_neighbours[i] = near > 0;
  }
};

/// Entries that a slice takes; 0 for the one after the last, so that the sums before each tell
/// where they start and how many there are.
struct MeasureSlice {
  const std::uint32_t* count;
  std::size_t particles;
  std::uint64_t* starts;
  SABO_HD void operator()(std::size_t s) const {
    std::uint32_t widest = 0;
    for (std::size_t i = s * PairRows::slice; i < (s + 1) * PairRows::slice && i < particles; ++i)
      widest = larger(widest, count[i]);
    starts[s] = std::uint64_t{widest} * PairRows::slice;
  }
};

struct WritePairs {
  PairSearch search;
  const std::uint64_t* starts;
  std::uint32_t* entries;
  SABO_HD void operator()(std::size_t i) const {
    std::uint64_t to = starts[i / PairRows::slice] + i % PairRows::slice;
    const auto write = [&](std::uint32_t j) {
      entries[to] = j;
      to += PairRows::slice;
    };
    search.near(search.fluid, i, write);
    if (i < search.fluid_count) search.near(search.boundary, i, write);
  }
};

/// Pairs, counted from the side of the fluid and of the boundary.
struct PairCount {
  std::uint64_t fluid = 0, boundary = 0;
  SABO_HD void join(const PairCount& other) {
    fluid += other.fluid;
    boundary += other.boundary;
  }
  std::uint64_t all() const { return fluid + boundary; }
};
struct SumPairs {
  const std::uint32_t* count;
  std::size_t fluid_count;
  SABO_HD void operator()(std::size_t i, PairCount& sum) const {
    (i < fluid_count ? sum.fluid : sum.boundary) += count[i];
  }
};
struct SumPairsAt {
  const std::uint32_t* rows;
  const std::uint32_t* count;
  SABO_HD void operator()(std::size_t k, Total& sum) const { sum.value += count[rows[k]]; }
};

}  // namespace sabo
