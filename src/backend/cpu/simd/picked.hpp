#pragma once

#include <array>
#include <cstdint>

#include "backend/cpu/simd/lanes.hpp"

namespace sabo {
namespace HWY_NAMESPACE {

/// The lanes that a mask picks, to be stored side by side. Each store writes a whole vector, of
/// which the first `count` entries count.
///
/// Vectors of up to eight lanes are shuffled by a table of ours: hn::Compress of Highway 1.0 holds
/// its table in the function, and GCC 12 copies that to the stack each time. Vectors of sixteen
/// compress in the register, which on some processors (AMD Zen 4) is many times faster than into
/// memory.
#if HWY_MAX_BYTES >= 64
class Picked {
 public:
  explicit Picked(hn::Mask<Lanes::Tag> mask) : mask_(mask) {}

  std::size_t count() const { return hn::CountTrue(Lanes::Tag(), mask_); }

  template <class D>
  void store(D d, hn::Vec<D> v, hn::TFromD<D>* to) const {
    hn::StoreU(hn::Compress(v, hn::RebindMask(d, mask_)), d, to);
  }

 private:
  hn::Mask<Lanes::Tag> mask_;
};
#else
struct PickTable {
  static constexpr std::size_t masks = std::size_t{1} << Lanes::count;

  std::array<std::array<std::uint8_t, Lanes::count>, masks> lane{};  ///< picked ones first
  std::array<std::uint8_t, masks> count{};

  constexpr PickTable() {
    for (std::size_t mask = 0; mask < masks; ++mask)
      for (std::size_t k = 0; k < Lanes::count; ++k)
        if (mask >> k & 1) lane[mask][count[mask]++] = static_cast<std::uint8_t>(k);
  }
};
inline constexpr PickTable pick_table;

class Picked {
 public:
  explicit Picked(hn::Mask<Lanes::Tag> mask) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(Lanes::Tag(), mask, bits);
    bits_ = bits[0];
  }

  std::size_t count() const { return pick_table.count[bits_]; }

  template <class D>
  void store(D d, hn::Vec<D> v, hn::TFromD<D>* to) const {
    const hn::RebindToSigned<D> places;
    const hn::Rebind<std::uint8_t, decltype(places)> bytes;
    const auto lanes = hn::PromoteTo(places, hn::LoadU(bytes, pick_table.lane[bits_].data()));
    hn::StoreU(hn::TableLookupLanes(v, hn::IndicesFromVec(d, lanes)), d, to);
  }

 private:
  std::size_t bits_;
};
#endif

}  // namespace HWY_NAMESPACE
}  // namespace sabo
