#pragma once

#include <array>
#include <cstdint>

#include "backend/cpu/simd/lanes.hpp"

namespace sabo {
namespace HWY_NAMESPACE {

// Neighbours are loaded as whole records of eight floats and transposed in registers, so that each
// costs one or two loads instead of eight gathers.

/// Transposes 4 x 4 floats within each 128-bit block of the four vectors.
template <class V>
HWY_INLINE void transpose_blocks(V& a, V& b, V& c, V& d) {
  const hn::DFromV<V> floats;
  const hn::Repartition<double, hn::DFromV<V>> pairs;
  const auto ab_low = hn::BitCast(pairs, hn::InterleaveLower(floats, a, b));
  const auto ab_high = hn::BitCast(pairs, hn::InterleaveUpper(floats, a, b));
  const auto cd_low = hn::BitCast(pairs, hn::InterleaveLower(floats, c, d));
  const auto cd_high = hn::BitCast(pairs, hn::InterleaveUpper(floats, c, d));
  a = hn::BitCast(floats, hn::InterleaveLower(pairs, ab_low, cd_low));
  b = hn::BitCast(floats, hn::InterleaveUpper(pairs, ab_low, cd_low));
  c = hn::BitCast(floats, hn::InterleaveLower(pairs, ab_high, cd_high));
  d = hn::BitCast(floats, hn::InterleaveUpper(pairs, ab_high, cd_high));
}

using Columns = std::array<Lanes, 8>;  ///< component k of all neighbours in the k-th entry

/// Reads components [offset, offset + 8) of Lanes::count records of `stride` floats each.
HWY_INLINE Columns load_transposed(const float* records, std::size_t stride, std::size_t offset,
                                   const std::uint32_t* index) {
  const auto at = [&](std::size_t k) { return records + stride * index[k] + offset; };
  Columns result;
#if HWY_MAX_BYTES >= 32
  // Rows k and k + 4 share a 256-bit vector; after the 4 x 4 transpositions within blocks, vector c
  // holds component c (first half of the record) or 4 + c (second half) of eight neighbours.
  const hn::FixedTag<float, 4> quad;
  const hn::FixedTag<float, 8> octet;
  using Octet = hn::Vec<decltype(octet)>;
  const auto eight = [&](std::size_t first, Octet* out) {
    for (std::size_t half = 0; half < 2; ++half) {
      Octet* c = out + 4 * half;
      for (std::size_t k = 0; k < 4; ++k)
        c[k] = hn::Combine(octet, hn::Load(quad, at(first + 4 + k) + 4 * half),
                           hn::Load(quad, at(first + k) + 4 * half));
      transpose_blocks(c[0], c[1], c[2], c[3]);
    }
  };
#if HWY_MAX_BYTES >= 64
  Octet low[8], high[8];
  eight(0, low);
  eight(8, high);
  for (std::size_t c = 0; c < 8; ++c) result[c] = hn::Combine(Lanes::Tag(), high[c], low[c]);
#else
  Octet columns[8];
  eight(0, columns);
  for (std::size_t c = 0; c < 8; ++c) result[c] = Lanes(columns[c]);
#endif
#else
  for (std::size_t half = 0; half < 2; ++half) {
    Lanes* c = result.data() + 4 * half;
    for (std::size_t k = 0; k < 4; ++k) c[k] = hn::Load(Lanes::Tag(), at(k) + 4 * half);
    transpose_blocks(c[0].v, c[1].v, c[2].v, c[3].v);
  }
#endif
  return result;
}

}  // namespace HWY_NAMESPACE
}  // namespace sabo
