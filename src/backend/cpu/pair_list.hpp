#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace sabo {

/// Neighbours of every particle, fluid neighbours first. Each of the two runs is padded to whole
/// SIMD vectors with the particle itself: a pair at distance zero with equal velocity, density and
/// stress adds exactly nothing to any sum, so the loops have no remainder.
class PairList {
 public:
  static constexpr std::size_t lanes = 16;   ///< floats in the widest vector (512 bits)
  static constexpr std::size_t chunk = 256;  ///< particles whose neighbours are stored together

  struct Row {
    const std::uint32_t* fluid;     ///< first fluid neighbour
    const std::uint32_t* boundary;  ///< first boundary neighbour, end of the fluid ones
    const std::uint32_t* end;
  };

  /// Where a row begins in its chunk, where its boundary part does, and where it ends.
  struct Offsets {
    std::uint32_t fluid = 0, boundary = 0, end = 0;
    std::uint32_t padding = 0;  ///< entries of both runs that are no pairs
  };

  void reset(std::size_t particles) {
    rows_.resize(particles);
    chunks_.resize((particles + chunk - 1) / chunk);
  }

  std::size_t chunk_count() const { return chunks_.size(); }
  /// Entries stored for chunk c.
  std::size_t chunk_length(std::size_t c) const { return chunks_[c].used; }
  std::size_t size() const { return rows_.size(); }
  Row row(std::size_t i) const {
    const std::uint32_t* base = chunks_[i / chunk].entries.data();
    const Offsets& o = rows_[i];
    return {base + o.fluid, base + o.boundary, base + o.end};
  }

  /// Listed pairs of particles [first, last), without padding.
  std::size_t pairs(std::size_t first, std::size_t last) const {
    std::size_t sum = 0;
    for (std::size_t i = first; i < last; ++i)
      sum += rows_[i].end - rows_[i].fluid - rows_[i].padding;
    return sum;
  }

  /// The entries of one chunk while they are written. Their memory is kept from list to list.
  class Chunk {
   public:
    /// Where the next entries go, with room for `count` of them and a vector more.
    std::uint32_t* room(std::size_t count) {
      if (used + count + lanes > entries.size()) entries.resize(2 * (used + count + lanes));
      return entries.data() + used;
    }
    void advance(std::size_t count) { used += count; }

   private:
    friend class PairList;
    std::vector<std::uint32_t> entries;
    std::size_t used = 0;
  };

  /// Fills one chunk: `append(i, part, chunk)` appends the neighbours of i, part 0 fluid and part 1
  /// boundary. Chunks may be filled by different threads; the outcome does not depend on it.
  template <class Append>
  void fill_chunk(std::size_t c, const Append& append) {
    Chunk& list = chunks_[c];
    list.used = 0;
    const std::size_t last = std::min(rows_.size(), (c + 1) * chunk);
    for (std::size_t i = c * chunk; i < last; ++i) {
      rows_[i].fluid = static_cast<std::uint32_t>(list.used);
      append(i, 0, list);
      rows_[i].padding = pad(list, rows_[i].fluid, i);
      rows_[i].boundary = static_cast<std::uint32_t>(list.used);
      append(i, 1, list);
      rows_[i].padding += pad(list, rows_[i].boundary, i);
      rows_[i].end = static_cast<std::uint32_t>(list.used);
    }
  }

 private:
  /// Returns how many entries it appended.
  static std::uint32_t pad(Chunk& list, std::size_t start, std::size_t self) {
    const std::size_t count = (lanes - (list.used - start) % lanes) % lanes;
    std::uint32_t* to = list.room(count);
    for (std::size_t k = 0; k < count; ++k) to[k] = static_cast<std::uint32_t>(self);
    list.advance(count);
    return static_cast<std::uint32_t>(count);
  }

  std::vector<Offsets> rows_;
  std::vector<Chunk> chunks_;
};

}  // namespace sabo
