// Compiled once for each instruction set, SABO_PARTS naming the result.

#include "microbench/simd_parts.hpp"

#include "backend/cpu/simd/lanes.hpp"
#include "backend/cpu/simd/transpose.hpp"
#include "physics/pair/density.hpp"
#include "physics/pair/forces.hpp"
#include "physics/pair/strain_rate.hpp"

namespace sabo {
namespace HWY_NAMESPACE {
namespace {

const Lanes::Tag tag;

WendlandC2<Lanes> kernel_of_bench() { return {Lanes(1.5f), Lanes(0.12f)}; }

float transpose_half(const float* records, const std::uint32_t* index, std::size_t count) {
  Lanes total;
  for (std::size_t k = 0; k < count; k += Lanes::count)
    for (const Lanes& column : load_transposed(records, 8, 0, index + k)) total += column;
  return sum(total);
}

float transpose_line(const float* records, const std::uint32_t* index, std::size_t count) {
  Lanes total;
  for (std::size_t k = 0; k < count; k += Lanes::count) {
    for (const Lanes& column : load_transposed(records, 16, 0, index + k)) total += column;
    for (const Lanes& column : load_transposed(records, 16, 8, index + k)) total += column;
  }
  return sum(total);
}

float kernel_gradient(const float* squared_distance, std::size_t count) {
  const WendlandC2<Lanes> kernel = kernel_of_bench();
  Lanes total;
  for (std::size_t k = 0; k < count; k += Lanes::count)
    total += kernel.gradient_factor(sqrt(Lanes(hn::LoadU(tag, squared_distance + k))));
  return sum(total);
}

float motion_formulas(const float* columns, std::size_t count) {
  const WendlandC2<Lanes> kernel = kernel_of_bench();
  const DensityDiffusion<Lanes> diffusion{
      Lanes(40.0f), Lanes(0.02f), {Lanes(0.0f), Lanes(0.0f), Lanes(-1e-4f)}};
  const Lanes rho0(1000.0f), zero(0.0f);
  Sym3<Lanes> eps;
  Lanes rate;
  for (std::size_t k = 0; k < count; k += Lanes::count) {
    const auto column = [&](std::size_t c) {
      return Lanes(hn::LoadU(tag, columns + c * count + k));
    };
    const auto pair = pair_geometry(Vec3<Lanes>{column(0), column(1), column(2)}, kernel);
    const Vec3<Lanes> v{column(3), column(4), column(5)};
    const Lanes excess = column(6), volume = column(7);
    const Lanes mass = volume * (rho0 + rho0 * excess);
    rate += continuity(pair, v, mass);
    rate += diffusion(pair, zero, excess, mass);
    eps += strain_rate(pair, v, volume);
  }
  return sum(rate + eps.xx + eps.xy + eps.xz + eps.yy + eps.yz + eps.zz);
}

float force_formulas(const float* columns, std::size_t count) {
  const WendlandC2<Lanes> kernel = kernel_of_bench();
  const Sym3<Lanes> mine{Lanes(1.0f), Lanes(0.1f), Lanes(0.2f),
                         Lanes(1.0f), Lanes(0.3f), Lanes(1.0f)};
  const Vec3<Lanes> velocity{Lanes(1.0f), Lanes(0.0f), Lanes(0.5f)};
  const Lanes pressure(1.0f);
  Vec3<Lanes> acceleration;
  Lanes power;
  for (std::size_t k = 0; k < count; k += Lanes::count) {
    const auto column = [&](std::size_t c) {
      return Lanes(hn::LoadU(tag, columns + c * count + k));
    };
    const auto pair = pair_geometry(Vec3<Lanes>{column(0), column(1), column(2)}, kernel);
    const Lanes mass = column(3);
    const Sym3<Lanes> stress{column(4), column(5), column(6), column(7), column(8), column(9)};
    acceleration += stress_force(pair, mine, stress, mass);
    power += pressure_power(pair, velocity, pressure, column(15), mass);
  }
  return sum(acceleration.x + acceleration.y + acceleration.z + power);
}

}  // namespace
}  // namespace HWY_NAMESPACE

extern const SimdParts SABO_PARTS;
const SimdParts SABO_PARTS{HWY_NAMESPACE::transpose_half, HWY_NAMESPACE::transpose_line,
                           HWY_NAMESPACE::kernel_gradient, HWY_NAMESPACE::motion_formulas,
                           HWY_NAMESPACE::force_formulas};

}  // namespace sabo
