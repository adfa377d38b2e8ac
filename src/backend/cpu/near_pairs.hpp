#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "backend/cpu/pair_list.hpp"

namespace sabo {

/// Pairs within the kernel at the present positions, and the conductances of the viscous matrix
/// that belong to them. The force sweep, which looks at every pair of the neighbour list, writes
/// them; the sweeps after it skip what the list holds for later steps. Rows are padded as in
/// PairList, with entries of zero.
class NearPairs {
  struct Chunk {
    std::vector<std::uint32_t> index;
    std::vector<float> conductance;
    std::size_t pairs = 0;  // entries that are no padding
  };

 public:
  struct Row {
    const std::uint32_t* fluid;     ///< first fluid neighbour
    const std::uint32_t* boundary;  ///< first boundary neighbour, end of the fluid ones
    const std::uint32_t* end;
    const float* conductance;  ///< kg/s, of the fluid neighbours
  };

  /// Writes the rows of one chunk, in order; rows left out are empty. Between rows it counts in its
  /// own members: the chunks lie side by side, and each belongs to another thread.
  class Writer {
   public:
    /// `most`: length of the chunk in the neighbour list. Whole vectors are stored, of which only
    /// the first part may count.
    Writer(NearPairs& pairs, std::size_t chunk, std::size_t most)
        : rows_(pairs.rows_), chunk_(pairs.chunks_[chunk]) {
      most += PairList::lanes;
      if (chunk_.index.size() < most) {
        chunk_.index.resize(most);
        chunk_.conductance.resize(most);
      }
      index_ = chunk_.index.data();
      conductance_ = chunk_.conductance.data();
      const std::size_t first = chunk * PairList::chunk;
      const std::size_t last = std::min(rows_.size(), first + PairList::chunk);
      for (std::size_t i = first; i < last; ++i) rows_[i] = {};
    }

    ~Writer() { chunk_.pairs = pairs_; }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    std::uint32_t* index() { return index_ + used_; }
    float* conductance() { return conductance_ + used_; }
    void advance(std::size_t count) {
      used_ += count;
      pairs_ += count;
    }

    void begin_row(std::size_t i) {
      row_ = i;
      rows_[i].fluid = rows_[i].boundary = rows_[i].end = static_cast<std::uint32_t>(used_);
    }
    void end_fluid() {
      pad(rows_[row_].fluid);
      rows_[row_].boundary = static_cast<std::uint32_t>(used_);
    }
    void end_row() {
      pad(rows_[row_].boundary);
      rows_[row_].end = static_cast<std::uint32_t>(used_);
    }

   private:
    void pad(std::size_t start) {
      while ((used_ - start) % PairList::lanes != 0) {
        index_[used_] = static_cast<std::uint32_t>(row_);
        conductance_[used_] = 0;
        ++used_;
      }
    }

    std::vector<PairList::Offsets>& rows_;
    Chunk& chunk_;
    std::uint32_t* index_ = nullptr;
    float* conductance_ = nullptr;
    std::size_t used_ = 0;
    std::size_t pairs_ = 0;
    std::size_t row_ = 0;
  };

  void reset(std::size_t particles) {
    rows_.resize(particles);
    chunks_.resize((particles + PairList::chunk - 1) / PairList::chunk);
  }

  /// Number of pairs, each counted from both its particles.
  std::size_t size() const {
    std::size_t sum = 0;
    for (const Chunk& chunk : chunks_) sum += chunk.pairs;
    return sum;
  }

  Row row(std::size_t i) const {
    const Chunk& chunk = chunks_[i / PairList::chunk];
    const PairList::Offsets& o = rows_[i];
    const std::uint32_t* base = chunk.index.data();
    return {base + o.fluid, base + o.boundary, base + o.end, chunk.conductance.data() + o.fluid};
  }

 private:
  std::vector<PairList::Offsets> rows_;
  std::vector<Chunk> chunks_;
};

}  // namespace sabo
