#pragma once

#include <cstdint>

#include "base/host_device.hpp"

namespace sabo {

/// Neighbours of every particle, fluid ones first; a particle of the boundary has fluid neighbours
/// only. Rows of 32 particles, which a device works on at once, lie interleaved: the k-th entries
/// of all of them side by side, so that they are read in one piece.
struct PairRows {
  static constexpr std::uint32_t slice = 32;

  const std::uint64_t* starts = nullptr;  ///< of each slice in the entries
  const std::uint32_t* entries = nullptr;
  const std::uint32_t* fluid = nullptr;  ///< number of fluid neighbours of each particle
  const std::uint32_t* count = nullptr;  ///< number of all its neighbours

  /// Index of the k-th neighbour of particle i.
  SABO_HD std::uint32_t at(std::size_t i, std::uint32_t k) const {
    return entries[starts[i / slice] + i % slice + std::uint64_t{k} * slice];
  }
};

/// A sweep over the pairs of a particle is a sum and what comes of it. Where particles are few,
/// several threads of a device share a row: each sums up every stride-th neighbour, from its first.
///   sums_of(i, share)   sums over a share of the pairs of particle i; they join()
///   finish(i, sums)     takes the sums over all of them
struct RowShare {
  std::uint32_t first = 0, stride = 1;
};

/// A sweep over pairs at the k-th of some rows.
template <class Sweep>
struct SweepAtRow {
  const std::uint32_t* index;
  Sweep sweep;
  SABO_HD auto sums_of(std::size_t k, RowShare share) const {
    return sweep.sums_of(std::size_t{index[k]}, share);
  }
  template <class Sums>
  SABO_HD void finish(std::size_t k, const Sums& sums) const {
    sweep.finish(std::size_t{index[k]}, sums);
  }
};

/// Calls f(j) for the fluid near a particle.
struct RowNear {
  PairRows rows;
  template <class F>
  SABO_HD void operator()(std::size_t i, const F& f) const {
    const std::uint32_t count = rows.fluid[i];
    for (std::uint32_t k = 0; k < count; ++k) f(std::size_t{rows.at(i, k)});
  }
};

}  // namespace sabo
