// Compiled once for each instruction set (src/CMakeLists.txt), SABO_SWEEPS naming the result.

#include "backend/cpu/pair_sweeps.hpp"

#include "backend/cpu/simd/implicit_sweeps.hpp"
#include "backend/cpu/simd/near_search.hpp"
#include "backend/cpu/simd/pair_constants.hpp"
#include "physics/pair/density.hpp"
#include "physics/pair/forces.hpp"
#include "physics/pair/strain_rate.hpp"

namespace sabo {
namespace HWY_NAMESPACE {
namespace {

static_assert(PairList::lanes % Lanes::count == 0, "rows are padded to whole vectors");

struct MotionSums {
  Sym3<Lanes> eps;
  Lanes rate, diffusion_rate;
};

/// Adds one run of neighbours. `diffusive` for fluid pairs; `wall` scales the strain of pairs
/// across the wall.
template <bool periodic, bool diffusive>
HWY_INLINE void add_motion(const Constants& s, const MotionTask& task, std::size_t i,
                           const std::uint32_t* begin, const std::uint32_t* end, float wall,
                           MotionSums& sums) {
  const MotionRecord& me = task.records[i];
  const std::int32_t place[3] = {me.x, me.y, me.z};
  const Vec velocity{Lanes(me.vx), Lanes(me.vy), Lanes(me.vz)};
  const Lanes excess(me.excess), wall_factor(wall);
  DensityDiffusion<Lanes> diffusion = s.diffusion;
  if constexpr (diffusive)
    diffusion.hydrostatic -=
        in_lanes(task.scale->hydrostatic_slope * task.scale->from_origin(me.x, me.y, me.z));
  const float* records = reinterpret_cast<const float*>(task.records);
  for (const std::uint32_t* k = begin; k != end; k += Lanes::count) {
    const Columns j = load_transposed(records, 8, 0, k);
    const auto pair = pair_geometry(separation<periodic>(s, place, j), s.kernel);
    const Vec v = velocity - Vec{j[3], j[4], j[5]};
    const Lanes excess_j = j[6], volume_j = j[7];
    const Lanes mass_j = volume_j * (s.rho0 + s.rho0 * excess_j);
    sums.rate += continuity(pair, v, mass_j);
    if constexpr (diffusive) sums.diffusion_rate += diffusion(pair, excess, excess_j, mass_j);
    sums.eps += strain_rate(pair, wall_factor * v, volume_j);
  }
}

template <bool periodic>
void motion_range(const MotionTask& task) {
  const Constants s(*task.scale);
  const float wall = task.scale->wall_velocity_factor;
  for (std::size_t i = task.first; i < task.last; ++i) {
    const PairList::Row row = task.list->row(i);
    MotionSums sums;
    if (i < task.fluid_count) {
      add_motion<periodic, true>(s, task, i, row.fluid, row.boundary, 1, sums);
      add_motion<periodic, false>(s, task, i, row.boundary, row.end, wall, sums);
    } else {
      add_motion<periodic, false>(s, task, i, row.fluid, row.boundary, wall, sums);
    }
    const Sym3<Lanes>& e = sums.eps;
    task.strain[i] = {sum(e.xx), sum(e.xy), sum(e.xz), sum(e.yy), sum(e.yz), sum(e.zz)};
    const float diffusion_rate = sum(sums.diffusion_rate);
    task.density_rate[i] = sum(sums.rate) + diffusion_rate;
    if (i < task.fluid_count) task.diffusion_rate[i] = diffusion_rate;
  }
}

struct ForceSums {
  Vec acceleration;
  Lanes pressure_power, wall_heat;
};

/// Adds one run of neighbours; `wall` is the velocity factor of pairs across the wall, whose
/// viscosity is that of the fluid; none: they are fluid.
template <bool periodic, bool two_point, bool artificial>
HWY_INLINE void add_force(const Constants& s, const ForceTask& task, std::size_t i,
                          const std::uint32_t* begin, const std::uint32_t* end, const float* wall,
                          ForceSums& sums) {
  const StressRecord& me = task.records[i];
  const std::int32_t place[3] = {me.x, me.y, me.z};
  const Sym3<Lanes> stress{Lanes(me.xx), Lanes(me.xy), Lanes(me.xz),
                           Lanes(me.yy), Lanes(me.yz), Lanes(me.zz)};
  const Vec velocity{Lanes(me.vx), Lanes(me.vy), Lanes(me.vz)};
  const Lanes viscosity(me.viscosity), density(me.density), pressure(me.pressure);
  const float* records = reinterpret_cast<const float*>(task.records);
  for (const std::uint32_t* k = begin; k != end; k += Lanes::count) {
    const Columns j = load_transposed(records, 16, 0, k);
    const Columns more = load_transposed(records, 16, 8, k);
    const auto pair = pair_geometry(separation<periodic>(s, place, j), s.kernel);
    const Lanes mass_j = j[3];
    const Sym3<Lanes> stress_j{j[4], j[5], j[6], j[7], more[0], more[1]};
    sums.acceleration += stress_force(pair, stress, stress_j, mass_j);
    sums.pressure_power += pressure_power(pair, velocity, pressure, more[7], mass_j);
    if (wall)
      sums.wall_heat +=
          pressure_loss(pair, velocity, Vec{more[2], more[3], more[4]}, pressure, more[7], mass_j);
    if constexpr (two_point || artificial) {
      const Vec v = velocity - Vec{more[2], more[3], more[4]};
      const Lanes viscosity_j = more[5], density_j = more[6];
      if constexpr (two_point) {
        const Lanes mu = wall ? Lanes(*wall) * viscosity : pair_viscosity(viscosity, viscosity_j);
        sums.acceleration += morris_force(pair, v, mu, mass_j / (density * density_j), s.eta2);
      }
      if constexpr (artificial)
        sums.acceleration += artificial_viscosity(pair, v, s.alpha_c0_h,
                                                  Lanes(2) * mass_j / (density + density_j), s.eta2)
                                 .acceleration;
    }
  }
}

template <bool periodic, bool two_point, bool artificial>
void force_range(const ForceTask& task) {
  const Constants s(*task.scale);
  const float* wall = &task.scale->wall_velocity_factor;
  for (std::size_t i = task.first; i < task.last; ++i) {
    const PairList::Row row = task.list->row(i);
    ForceSums sums;
    add_force<periodic, two_point, artificial>(s, task, i, row.fluid, row.boundary, nullptr, sums);
    add_force<periodic, two_point, artificial>(s, task, i, row.boundary, row.end, wall, sums);
    const Vec& a = sums.acceleration;
    task.acceleration[i] = task.gravity + Vec3d{sum(a.x), sum(a.y), sum(a.z)};
    task.pressure_power[i] = sum(sums.pressure_power);
    task.wall_heat[i] = sum(sums.wall_heat);
  }
}

template <bool periodic>
void force_with_switches(const ForceTask& task) {
  const bool artificial = task.scale->alpha_c0_h > 0;
  if (task.scale->two_point_viscosity)
    artificial ? force_range<periodic, true, true>(task) : force_range<periodic, true, false>(task);
  else
    artificial ? force_range<periodic, false, true>(task)
               : force_range<periodic, false, false>(task);
}

void motion(const MotionTask& task) {
  task.scale->periodic ? motion_range<true>(task) : motion_range<false>(task);
}

void force(const ForceTask& task) {
  task.scale->periodic ? force_with_switches<true>(task) : force_with_switches<false>(task);
}

}  // namespace
}  // namespace HWY_NAMESPACE

extern const PairSweeps SABO_SWEEPS;
const PairSweeps SABO_SWEEPS{
    hwy::TargetName(HWY_STATIC_TARGET), HWY_NAMESPACE::motion,     HWY_NAMESPACE::force,
    HWY_NAMESPACE::wall_pressure,       HWY_NAMESPACE::near_force, HWY_NAMESPACE::wall_closing,
    HWY_NAMESPACE::near_motion,         HWY_NAMESPACE::shift,      HWY_NAMESPACE::half_gradient,
    HWY_NAMESPACE::viscous_product,     HWY_NAMESPACE::near_search};

}  // namespace sabo
