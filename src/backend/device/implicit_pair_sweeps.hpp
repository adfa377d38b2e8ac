#pragma once

#include "backend/device/viscous_pair_sweeps.hpp"
#include "backend/sweeps/shifting.hpp"
#include "backend/viscous_solver.hpp"
#include "physics/pair/wall_contact.hpp"

// The sums over pairs of the implicit method, one particle at a time, in single precision.

namespace sabo {

/// Whether a boundary particle, counted from the first, has a fluid particle near it that is awake
/// or driven.
struct IsTouched {
  std::size_t fluid_count;
  PairRows rows;
  const char* moves;
  SABO_HD bool operator()(std::size_t b) const {
    const std::size_t i = fluid_count + b;
    for (std::uint32_t k = 0; k < rows.fluid[i]; ++k)
      if (moves[rows.at(i, k)]) return true;
    return false;
  }
};

struct PackFlow {
  RecordPacker pack;
  FlowView flow;
  FlowRecord* records;
  SABO_HD void operator()(std::size_t i) const { records[i] = pack.flow(flow.fluid, i); }
};

/// Pressure, density and record of a wall particle from the fluid near it (Adami et al. 2012,
/// Eq. 27), and the sum of weights that belongs to it.
struct WallPressureSweep {
  PairSums pairs;
  RecordPacker pack;
  FlowView flow;
  FlowRecord* records;
  float* weights;  ///< by boundary particle

  struct Sums {
    float weight = 0, pressure = 0;
    SABO_HD void join(const Sums& other) {
      weight += other.weight;
      pressure += other.pressure;
    }
  };

  SABO_HD Sums sums_of(std::size_t b, RowShare share) const {
    const PairScale& scale = pairs.scale;
    const std::size_t i = flow.fluid_count + b;
    const IntegerPlace me = pack.place(flow.boundary.position[b]);
    const Vec3f force =
        in_single(flow.model.gravity) - scale.central * scale.from_origin(me.x, me.y, me.z);
    const auto kernel = pairs.kernel();
    const float rho2 = scale.rho0 * scale.rho0;
    Sums sums;
    for (std::uint32_t k = share.first; k < pairs.rows.fluid[i]; k += share.stride) {
      const FlowRecord j = records[pairs.rows.at(i, k)];
      const Vec3f x = pairs.separation(me, j);
      const float w = kernel.value(norm(x));
      sums.weight += w;
      sums.pressure += w * (j.pressure * rho2 + j.density * dot(force, x));
    }
    return sums;
  }
  SABO_HD void finish(std::size_t b, const Sums& sums) const {
    weights[b] = sums.weight;
    const double mean = sums.weight > 0 ? sums.pressure / sums.weight : 0.0f;
    // A wall does not pull.
    flow.boundary.pressure[b] = larger(mean, 0.0);
    flow.boundary.density[b] = flow.model.state.density(flow.boundary.pressure[b]);
    records[flow.fluid_count + b] = pack.flow(flow.boundary, b);
  }
};

/// Records of motion at the places of the other ones.
struct PackMotionBeside {
  RecordPacker pack;
  ParticleView of;
  std::size_t offset;
  const FlowRecord* places;
  MotionRecord* records;
  SABO_HD void operator()(std::size_t i) const {
    const FlowRecord& at = places[offset + i];
    records[offset + i] = pack.motion(of, i, {at.x, at.y, at.z});
  }
};

/// Acceleration by the body force and pressure, the row sum of the viscous matrix, and where the
/// walls are. `with_motion`: for artificial viscosity and moving walls.
template <bool with_motion>
struct NearForceSweep {
  PairSums pairs;
  const FlowRecord* records;
  const MotionRecord* motion;
  FlowView flow;
  float* conductance_sum;
  Sym3<float>* inverse_root;

  struct Sums {
    Vec3f acceleration;
    float conductance = 0, artificial_heat = 0;
    Sym3<float> moments;  // of the conductances
    float filling = 0, share = 0;
    Vec3f filling_gradient, gradient, wall_velocity;
    SABO_HD void join(const Sums& other) {
      acceleration += other.acceleration;
      conductance += other.conductance;
      moments += other.moments;
      artificial_heat += other.artificial_heat;
      filling += other.filling;
      share += other.share;
      filling_gradient += other.filling_gradient;
      gradient += other.gradient;
      wall_velocity += other.wall_velocity;
    }
  };

  SABO_HD Sums sums_of(std::size_t i, RowShare share) const {
    const std::uint32_t fluid = pairs.rows.fluid[i], count = pairs.rows.count[i];
    const FlowRecord me = records[i];
    Sums sums;
    std::uint32_t k = share.first;
    for (; k < fluid; k += share.stride) add_fluid(i, me, pairs.rows.at(i, k), sums);
    for (; k < count; k += share.stride) add_wall(me, pairs.rows.at(i, k), sums);
    return sums;
  }
  SABO_HD void finish(std::size_t i, const Sums& sums) const {
    const float own = pairs.scale.kernel_alpha * records[i].volume;  // W(0) V
    flow.acceleration[i] =
        flow.model.body_force(flow.fluid.position[i]) + in_double(sums.acceleration);
    if constexpr (with_motion)
      if (flow.artificial_heat) flow.artificial_heat[i] = sums.artificial_heat;
    conductance_sum[i] = sums.conductance;
    if (pairs.scale.whole_viscous_stress)  // else zero
      inverse_root[i] =
          in_single(sabo::inverse_root(in_double(sums.moments), pairs.scale.dimension));
    flow.filling[i] = {own + sums.filling + sums.share,
                       in_double(sums.filling_gradient + sums.gradient)};
    flow.wall[i] = {sums.share, in_double(sums.gradient), in_double(sums.wall_velocity)};
  }

 private:
  SABO_HD void add_fluid(std::size_t i, const FlowRecord& me, std::uint32_t index,
                         Sums& sums) const {
    const FlowRecord j = records[index];
    const auto pair = pairs.geometry(me, j);
    sums.acceleration += pressure_force(pair, me.pressure, j.pressure, j.mass);
    const float a = conductance(pair, me, j);
    sums.conductance += a;
    if (pairs.scale.whole_viscous_stress) sums.moments += scaled_square(a, pair.x);
    sums.filling += j.volume * pairs.kernel().value(std::sqrt(pair.r2));
    sums.filling_gradient += (j.volume * pair.gradient) * pair.x;
    if constexpr (with_motion) {
      const Vec3f v = PairSums::velocity(motion[i]) - PairSums::velocity(motion[index]);
      const auto artificial = artificial_viscosity(
          pair, v, pairs.scale.alpha_c0_h, 2 * j.mass / (me.density + j.density), pairs.scale.eta2);
      sums.acceleration += artificial.acceleration;
      sums.artificial_heat += artificial.heat;
    }
  }

  SABO_HD void add_wall(const FlowRecord& me, std::uint32_t index, Sums& sums) const {
    const FlowRecord j = records[index];
    const auto pair = pairs.geometry(me, j);
    sums.acceleration += pressure_force(pair, me.pressure, j.pressure, j.mass);
    const float part = j.volume * pairs.kernel().value(std::sqrt(pair.r2));
    sums.share += part;
    sums.gradient += (j.volume * pair.gradient) * pair.x;
    if constexpr (with_motion) sums.wall_velocity += part * PairSums::velocity(motion[index]);
  }
};

/// Rate at which fluid closes in on a wall particle under pressure (physics/pair/wall_contact.hpp).
struct WallClosingSweep {
  PairSums pairs;
  const MotionRecord* records;
  FlowView flow;
  const float* weights;
  ClosingRecord* closings;  ///< by boundary particle

  struct Sums {
    float rate = 0;
    Vec3f gradient;
    SABO_HD void join(const Sums& other) {
      rate += other.rate;
      gradient += other.gradient;
    }
  };

  SABO_HD Sums sums_of(std::size_t b, RowShare share) const {
    Sums sums;
    if (!(flow.boundary.pressure[b] > 0)) return sums;
    const std::size_t i = flow.fluid_count + b;
    const MotionRecord me = records[i];
    const Vec3f velocity = PairSums::velocity(me);
    for (std::uint32_t k = share.first; k < pairs.rows.fluid[i]; k += share.stride) {
      const MotionRecord j = records[pairs.rows.at(i, k)];
      const auto pair = pairs.geometry(me, j);
      sums.rate += closing(pair, velocity - PairSums::velocity(j));
      sums.gradient += pair.gradient * pair.x;
    }
    return sums;
  }
  SABO_HD void finish(std::size_t b, const Sums& sums) const {
    closings[b] = {};
    if (!(flow.boundary.pressure[b] > 0)) return;
    const float scale = 1 / weights[b];
    const Vec3f gradient = scale * sums.gradient;
    closings[b] = {scale * sums.rate, gradient.x, gradient.y, gradient.z, {}};
  }
};

/// Strain rate and density rate of the fluid with its new velocity.
struct NearMotionSweep {
  PairSums pairs;
  const MotionRecord* records;
  const ClosingRecord* closings;  ///< by boundary particle
  FlowView flow;

  struct Sums {
    Sym3<float> eps;
    float rate = 0, diffusion_rate = 0, wall_rate = 0, support = 0;
    SABO_HD void join(const Sums& other) {
      eps += other.eps;
      rate += other.rate;
      diffusion_rate += other.diffusion_rate;
      wall_rate += other.wall_rate;
      support += other.support;
    }
  };

  SABO_HD Sums sums_of(std::size_t i, RowShare share) const {
    const MotionRecord me = records[i];
    Sums sums;
    std::uint32_t k = share.first;
    add_fluid(i, me, k, share.stride, sums);
    add_walls(i, me, k, share.stride, sums);
    return sums;
  }
  SABO_HD void finish(std::size_t i, const Sums& sums) const {
    const float support = sums.support * (-1.0f / static_cast<float>(pairs.scale.dimension));
    // Where a part of the kernel is empty every derivative comes out too small by about that part.
    const double scale = 1 / larger(support, static_cast<float>(least_support));
    flow.strain[i] = scale * in_double(sums.eps);
    flow.diffusion_rate[i] = sums.diffusion_rate;
    flow.density_rate[i] =
        sums.rate + sums.diffusion_rate + one_sided(sums.wall_rate, records[i].excess);
    flow.support[i] = support;
  }

 private:
  SABO_HD void add_fluid(std::size_t i, const MotionRecord& me, std::uint32_t& k,
                         std::uint32_t stride, Sums& sums) const {
    const Vec3f velocity = PairSums::velocity(me);
    const auto diffusion =
        pairs.diffusion(flow.background ? in_single(flow.background[i]) : Vec3f{});
    for (; k < pairs.rows.fluid[i]; k += stride) {
      const MotionRecord j = records[pairs.rows.at(i, k)];
      const auto pair = pairs.geometry(me, j);
      const Vec3f v = velocity - PairSums::velocity(j);
      const float mass = pairs.mass(j);
      sums.rate += continuity(pair, v, mass);
      sums.diffusion_rate += diffusion(pair, me.excess, j.excess, mass);
      sums.eps += strain_rate(pair, v, j.volume);
      sums.support += j.volume * pair.gradient * pair.r2;
    }
  }

  /// The flow goes on into the wall as it comes from it, through the wall's velocity at the wall
  /// (Morris et al. 1997): the difference grows with the distance along the normal. Where it
  /// slides, only that share of its velocity along the wall by which it is held.
  SABO_HD void add_walls(std::size_t i, const MotionRecord& me, std::uint32_t k,
                         std::uint32_t stride, Sums& sums) const {
    const Vec3f velocity = PairSums::velocity(me);
    const Vec3d& n = flow.grip[i].slope;
    const Vec3f slope = in_single(n);
    const Vec3f normal = in_single(norm(n) > 0 ? normalised(n) : n);
    const auto slides = static_cast<float>(1 - flow.grip[i].held);
    const auto kernel = pairs.kernel();
    for (; k < pairs.rows.count[i]; k += stride) {
      const std::uint32_t index = pairs.rows.at(i, k);
      const MotionRecord j = records[index];
      const auto pair = pairs.geometry(me, j);
      const Vec3f v = velocity - PairSums::velocity(j);
      const float mass = pairs.mass(j);
      const float weight = kernel.value(std::sqrt(pair.r2));
      const ClosingRecord c = closings[index - pairs.fluid_count];
      const Vec3f past = along(v, normal);
      sums.wall_rate +=
          continuity(pair, v, mass) + handed_back(mass * weight, past, c.rate, {c.gx, c.gy, c.gz});
      sums.eps +=
          strain_rate(pair, larger(dot(slope, pair.x), 0.0f) * (v - slides * past), j.volume);
      sums.support += j.volume * pair.gradient * pair.r2;
    }
  }
};

/// What shifts fill, of records whose velocities are shifts.
struct ShiftSweep {
  PairSums pairs;
  const MotionRecord* records;
  FillByShifts fill;

  struct Sums {
    float near = 0;
    SABO_HD void join(const Sums& other) { near += other.near; }
  };

  SABO_HD Sums sums_of(std::size_t i, RowShare share) const {
    const MotionRecord me = records[i];
    Sums sums;
    for (std::uint32_t k = share.first; k < pairs.rows.fluid[i]; k += share.stride) {
      const MotionRecord j = records[pairs.rows.at(i, k)];
      sums.near += continuity(pairs.geometry(me, j), PairSums::velocity(j), j.volume);
    }
    return sums;
  }
  SABO_HD void finish(std::size_t i, const Sums& sums) const { fill(i, sums.near); }
};

}  // namespace sabo
