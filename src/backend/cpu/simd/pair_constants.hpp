#pragma once

#include "backend/cpu/pair_sweeps.hpp"
#include "backend/cpu/simd/lanes.hpp"
#include "backend/cpu/simd/transpose.hpp"
#include "physics/kernel.hpp"
#include "physics/pair/density.hpp"

namespace sabo {
namespace HWY_NAMESPACE {

using Vec = Vec3<Lanes>;

/// Constants of the pair sweeps in every lane.
struct Constants {
  explicit Constants(const PairScale& s)
      : unit(s.unit),
        kernel{Lanes(s.h), Lanes(s.kernel_alpha)},
        eta2(s.eta2),
        rho0(s.rho0),
        diffusion{Lanes(s.two_zeta_h_c0),
                  eta2,
                  {Lanes(s.hydrostatic.x), Lanes(s.hydrostatic.y), Lanes(s.hydrostatic.z)}},
        alpha_c0_h(s.alpha_c0_h) {
    for (int axis = 0; axis < 3; ++axis) {
      inverse_period[axis] = Lanes(s.inverse_period[axis]);
      const Vec3f& p = s.period[axis];
      period[axis] = {Lanes(p.x), Lanes(p.y), Lanes(p.z)};
    }
  }

  Lanes unit;
  WendlandC2<Lanes> kernel;
  Lanes eta2, rho0;
  DensityDiffusion<Lanes> diffusion;
  Lanes alpha_c0_h;
  Lanes inverse_period[3];
  Vec period[3];
};

HWY_INLINE Vec in_lanes(const Vec3f& v) { return {Lanes(v.x), Lanes(v.y), Lanes(v.z)}; }

/// x_i - x_j from integer positions; on periodic axes the nearest image. Integer subtraction wraps
/// by definition and is exact.
template <bool periodic>
HWY_INLINE Vec separation(const Constants& s, const std::int32_t (&i)[3], const Columns& j) {
  const hn::RebindToSigned<Lanes::Tag> integers;
  const auto difference = [&](int axis) {
    const auto d = hn::Sub(hn::Set(integers, i[axis]), hn::BitCast(integers, j[axis].v));
    return s.unit * Lanes(hn::ConvertTo(Lanes::Tag(), d));
  };
  Vec x{difference(0), difference(1), difference(2)};
  if constexpr (periodic) {
    x -= round(x.x * s.inverse_period[0]) * s.period[0];
    x -= round(x.y * s.inverse_period[1]) * s.period[1];
    x -= round(x.z * s.inverse_period[2]) * s.period[2];
  }
  return x;
}

}  // namespace HWY_NAMESPACE
}  // namespace sabo
