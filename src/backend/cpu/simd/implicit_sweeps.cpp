// Compiled once for each instruction set, as pair_sweeps.cpp is.

#include "backend/cpu/simd/implicit_sweeps.hpp"

#include <algorithm>

#include "backend/cpu/simd/pair_constants.hpp"
#include "backend/cpu/simd/picked.hpp"
#include "physics/pair/density.hpp"
#include "physics/pair/forces.hpp"
#include "physics/pair/strain_rate.hpp"
#include "physics/pair/viscous_flux.hpp"
#include "physics/pair/wall_contact.hpp"

namespace sabo {
namespace HWY_NAMESPACE {
namespace {

template <bool periodic>
HWY_INLINE Vec separation_from(const Constants& s, const FlowRecord& me, const Columns& j) {
  const std::int32_t place[3] = {me.x, me.y, me.z};
  return separation<periodic>(s, place, j);
}

HWY_INLINE Sym3<double> sum_of_lanes(const Sym3<Lanes>& a) {
  return {sum(a.xx), sum(a.xy), sum(a.xz), sum(a.yy), sum(a.yz), sum(a.zz)};
}

HWY_INLINE Columns flow_records(const FlowRecord* records, const std::uint32_t* k) {
  return load_transposed(reinterpret_cast<const float*>(records), 8, 0, k);
}
HWY_INLINE Columns motion_records(const MotionRecord* records, const std::uint32_t* k) {
  return load_transposed(reinterpret_cast<const float*>(records), 8, 0, k);
}

HWY_INLINE Columns closing_records(const ClosingRecord* records, const std::uint32_t* k) {
  return load_transposed(reinterpret_cast<const float*>(records), 8, 0, k);
}

template <bool periodic>
void wall_pressure_range(const WallPressureTask& task) {
  const Constants s(*task.scale);
  for (std::size_t place = task.first; place < task.last; ++place) {
    const std::size_t i = task.rows[place];
    const PairList::Row row = task.list->row(i);
    const FlowRecord& me = task.records[i];
    const Vec3f from = task.scale->from_origin(me.x, me.y, me.z);
    const Vec gravity = in_lanes(task.gravity - task.scale->central * from);
    Lanes weight, pressure;
    for (const std::uint32_t* k = row.fluid; k != row.boundary; k += Lanes::count) {
      const Columns j = flow_records(task.records, k);
      const Vec x = separation_from<periodic>(s, me, j);
      const Lanes r2 = dot(x, x), density = j[7];
      // Rows are padded with the particle itself, which has no say in its own pressure.
      const Lanes w = s.kernel.value(sqrt(r2)) * positive(r2);
      weight += w;
      pressure += w * (j[4] * (s.rho0 * s.rho0) + density * dot(gravity, x));
    }
    const float total = sum(weight);
    task.weight[place] = total;
    task.pressure[place] = total > 0 ? sum(pressure) / total : 0;
  }
}

template <bool periodic>
void wall_closing_range(const WallClosingTask& task) {
  const Constants s(*task.scale);
  for (std::size_t place = task.first; place < task.last; ++place) {
    const std::size_t i = task.rows[place];
    ClosingRecord& closing_of = task.closing[i];
    closing_of = {};
    if (!(task.pressure[place] > 0)) continue;
    const PairList::Row row = task.list->row(i);
    const MotionRecord& me = task.records[i];
    const std::int32_t at[3] = {me.x, me.y, me.z};
    const Vec velocity{Lanes(me.vx), Lanes(me.vy), Lanes(me.vz)};
    Lanes rate;
    Vec gradient;
    for (const std::uint32_t* k = row.fluid; k != row.boundary; k += Lanes::count) {
      const Columns j = motion_records(task.records, k);
      const auto pair = pair_geometry(separation<periodic>(s, at, j), s.kernel);
      rate += closing(pair, velocity - Vec{j[3], j[4], j[5]});
      gradient += pair.gradient * pair.x;
    }
    const float scale = 1 / task.weight[place];
    closing_of = {scale * sum(rate),
                  scale * sum(gradient.x),
                  scale * sum(gradient.y),
                  scale * sum(gradient.z),
                  {}};
  }
}

struct NearForceSums {
  Vec acceleration;
  Lanes conductance;
  Sym3<Lanes> moments;  // of the conductances
  Lanes filling;
  Vec filling_gradient;
  Lanes share;
  Vec gradient, wall_velocity;
  Lanes artificial_heat;
};

template <bool periodic, bool with_motion>
HWY_INLINE void add_fluid_forces(const Constants& s, const NearForceTask& task, std::size_t i,
                                 const PairList::Row& row, NearForceSums& sums) {
  const hn::RebindToUnsigned<Lanes::Tag> indices;
  const FlowRecord& me = task.records[i];
  const Lanes pressure(me.pressure), volume(me.volume), viscosity(me.viscosity);
  const Lanes density(me.density);
  for (const std::uint32_t* k = row.fluid; k != row.boundary; k += Lanes::count) {
    const Columns j = flow_records(task.records, k);
    const auto pair = pair_geometry(separation_from<periodic>(s, me, j), s.kernel);
    sums.acceleration += pressure_force(pair, pressure, j[4], j[3]);
    // Rows are padded with the particle itself, which does not rub against itself.
    const Lanes a = viscous_conductance(pair, pair_viscosity(viscosity, j[6]), volume, j[5]) *
                    positive(pair.r2);
    sums.conductance += a;
    if (task.scale->whole_viscous_stress) sums.moments += scaled_square(a, pair.x);
    sums.filling += j[5] * s.kernel.value(sqrt(pair.r2)) * positive(pair.r2);
    sums.filling_gradient += (j[5] * pair.gradient) * pair.x;
    if constexpr (with_motion) {
      const Columns m = motion_records(task.motion, k);
      const MotionRecord& mine = task.motion[i];
      const Vec v = Vec{Lanes(mine.vx), Lanes(mine.vy), Lanes(mine.vz)} - Vec{m[3], m[4], m[5]};
      const auto artificial =
          artificial_viscosity(pair, v, s.alpha_c0_h, Lanes(2) * j[3] / (density + j[7]), s.eta2);
      sums.acceleration += artificial.acceleration;
      sums.artificial_heat += artificial.heat;
    }
    const Picked near(hn::Lt((pair.gradient * pair.r2).v, hn::Zero(Lanes::Tag())));
    near.store(indices, hn::LoadU(indices, k), task.near->index());
    near.store(Lanes::Tag(), a.v, task.near->conductance());
    task.near->advance(near.count());
  }
}

template <bool periodic, bool with_motion>
HWY_INLINE void add_wall_forces(const Constants& s, const NearForceTask& task, std::size_t i,
                                const PairList::Row& row, NearForceSums& sums) {
  const hn::RebindToUnsigned<Lanes::Tag> indices;
  const FlowRecord& me = task.records[i];
  const Lanes pressure(me.pressure);
  for (const std::uint32_t* k = row.boundary; k != row.end; k += Lanes::count) {
    const Columns j = flow_records(task.records, k);
    const auto pair = pair_geometry(separation_from<periodic>(s, me, j), s.kernel);
    sums.acceleration += pressure_force(pair, pressure, j[4], j[3]);
    const Lanes part = j[5] * s.kernel.value(sqrt(pair.r2)) * positive(pair.r2);
    sums.share += part;
    sums.gradient += (j[5] * pair.gradient) * pair.x;
    if constexpr (with_motion) {
      const Columns m = motion_records(task.motion, k);
      sums.wall_velocity += part * Vec{m[3], m[4], m[5]};
    }
    const Picked near(hn::Lt((pair.gradient * pair.r2).v, hn::Zero(Lanes::Tag())));
    near.store(indices, hn::LoadU(indices, k), task.near->index());
    task.near->advance(near.count());
  }
}

template <bool periodic, bool with_motion>
void near_force_range(const NearForceTask& task) {
  const Constants s(*task.scale);
  const float own = task.scale->kernel_alpha;  // W(0)
  for (std::size_t k = task.first; k < task.last; ++k) {
    const std::size_t i = task.rows[k];
    const PairList::Row row = task.list->row(i);
    NearForceSums sums;
    task.near->begin_row(i);
    add_fluid_forces<periodic, with_motion>(s, task, i, row, sums);
    task.near->end_fluid();
    if (row.boundary != row.end) add_wall_forces<periodic, with_motion>(s, task, i, row, sums);
    task.near->end_row();
    const Vec& a = sums.acceleration;
    const Vec& n = sums.gradient;
    const Vec& w = sums.wall_velocity;
    task.acceleration[i] = task.gravity + Vec3d{sum(a.x), sum(a.y), sum(a.z)};
    task.artificial_heat[i] = sum(sums.artificial_heat);
    task.conductance_sum[i] = sum(sums.conductance);
    if (task.scale->whole_viscous_stress)  // else zero
      task.inverse_root[i] =
          in_single(inverse_root(sum_of_lanes(sums.moments), task.scale->dimension));
    const float share = sum(sums.share);
    const Vec full = sums.filling_gradient + n;
    task.filling[i] = {own * task.records[i].volume + sum(sums.filling) + share,
                       {sum(full.x), sum(full.y), sum(full.z)}};
    task.wall[i] = {share, {sum(n.x), sum(n.y), sum(n.z)}, {sum(w.x), sum(w.y), sum(w.z)}};
  }
}

struct NearMotionSums {
  Sym3<Lanes> eps;
  Lanes rate, diffusion_rate, wall_rate;
  Lanes support;
};

template <bool periodic>
HWY_INLINE void add_near_motion(const Constants& s, const NearMotionTask& task, std::size_t i,
                                const NearPairs::Row& row, NearMotionSums& sums) {
  const MotionRecord& me = task.records[i];
  const std::int32_t place[3] = {me.x, me.y, me.z};
  const Vec velocity{Lanes(me.vx), Lanes(me.vy), Lanes(me.vz)};
  const Lanes excess(me.excess);
  const Vec3d& b = task.background[i];
  DensityDiffusion<Lanes> diffusion = s.diffusion;
  diffusion.hydrostatic = {Lanes(float(b.x)), Lanes(float(b.y)), Lanes(float(b.z))};
  for (const std::uint32_t* k = row.fluid; k != row.boundary; k += Lanes::count) {
    const Columns j = motion_records(task.records, k);
    const auto pair = pair_geometry(separation<periodic>(s, place, j), s.kernel);
    const Vec v = velocity - Vec{j[3], j[4], j[5]};
    const Lanes mass_j = j[7] * (s.rho0 + s.rho0 * j[6]);
    sums.rate += continuity(pair, v, mass_j);
    sums.diffusion_rate += diffusion(pair, excess, j[6], mass_j);
    sums.eps += strain_rate(pair, v, j[7]);
    sums.support += j[7] * pair.gradient * pair.r2;
  }
  if (row.boundary == row.end) return;
  const Vec3d& n = task.grip[i].slope;
  const Vec slope{Lanes(float(n.x)), Lanes(float(n.y)), Lanes(float(n.z))};
  const Vec3d unit = norm(n) > 0 ? normalised(n) : n;
  const Vec normal{Lanes(float(unit.x)), Lanes(float(unit.y)), Lanes(float(unit.z))};
  const Lanes slides(static_cast<float>(1 - task.grip[i].held));
  for (const std::uint32_t* k = row.boundary; k != row.end; k += Lanes::count) {
    const Columns j = motion_records(task.records, k);
    const auto pair = pair_geometry(separation<periodic>(s, place, j), s.kernel);
    const Vec v = velocity - Vec{j[3], j[4], j[5]};
    const Lanes mass_j = j[7] * (s.rho0 + s.rho0 * j[6]);
    const Lanes weight = s.kernel.value(sqrt(pair.r2)) * positive(pair.r2);
    const Columns c = closing_records(task.closing, k);
    const Vec past = along(v, normal);
    sums.wall_rate +=
        continuity(pair, v, mass_j) + handed_back(mass_j * weight, past, c[0], {c[1], c[2], c[3]});
    // The flow goes on into the wall as it comes from it, through the wall's velocity at the wall
    // (Morris et al. 1997): the difference grows with the distance along the normal. Where it
    // slides, only that share of its velocity along the wall by which it is held.
    sums.eps +=
        strain_rate(pair, larger(dot(slope, pair.x), Lanes(0.0f)) * (v - slides * past), j[7]);
    sums.support += j[7] * pair.gradient * pair.r2;
  }
}

template <bool periodic>
void near_motion_range(const NearMotionTask& task) {
  const Constants s(*task.scale);
  const float per_dimension = -1.0f / static_cast<float>(task.scale->dimension);
  for (std::size_t k = task.first; k < task.last; ++k) {
    const std::size_t i = task.rows[k];
    NearMotionSums sums;
    add_near_motion<periodic>(s, task, i, task.near->row(i), sums);
    const float support = per_dimension * sum(sums.support);
    // Where a part of the kernel is empty every derivative comes out too small by about that part.
    const double scale = 1 / std::max(static_cast<float>(least_support), support);
    task.strain[i] = scale * sum_of_lanes(sums.eps);
    const float diffusion_rate = sum(sums.diffusion_rate);
    const float wall_rate = one_sided(sum(sums.wall_rate), task.records[i].excess);
    task.diffusion_rate[i] = diffusion_rate;
    task.density_rate[i] = sum(sums.rate) + diffusion_rate + wall_rate;
    task.support[i] = support;
  }
}

template <bool periodic>
void shift_range(const ShiftTask& task) {
  const Constants s(*task.scale);
  for (std::size_t place = task.first; place < task.last; ++place) {
    const std::size_t i = task.rows[place];
    const NearPairs::Row row = task.near->row(i);
    const MotionRecord& me = task.records[i];
    const std::int32_t at[3] = {me.x, me.y, me.z};
    Lanes total;
    for (const std::uint32_t* k = row.fluid; k != row.boundary; k += Lanes::count) {
      const Columns j = motion_records(task.records, k);
      const auto pair = pair_geometry(separation<periodic>(s, at, j), s.kernel);
      total += continuity(pair, Vec{j[3], j[4], j[5]}, j[7]);
    }
    task.sum[place - task.first] = sum(total);
  }
}

}  // namespace

void wall_pressure(const WallPressureTask& task) {
  task.scale->periodic ? wall_pressure_range<true>(task) : wall_pressure_range<false>(task);
}

void wall_closing(const WallClosingTask& task) {
  task.scale->periodic ? wall_closing_range<true>(task) : wall_closing_range<false>(task);
}

void near_force(const NearForceTask& task) {
  if (task.needs_motion)
    task.scale->periodic ? near_force_range<true, true>(task) : near_force_range<false, true>(task);
  else
    task.scale->periodic ? near_force_range<true, false>(task)
                         : near_force_range<false, false>(task);
}

void near_motion(const NearMotionTask& task) {
  task.scale->periodic ? near_motion_range<true>(task) : near_motion_range<false>(task);
}

void shift(const ShiftTask& task) {
  task.scale->periodic ? shift_range<true>(task) : shift_range<false>(task);
}

}  // namespace HWY_NAMESPACE
}  // namespace sabo
