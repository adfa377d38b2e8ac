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
