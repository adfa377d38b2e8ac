#pragma once

#include <cmath>

#include "backend/device/column_search.hpp"
#include "backend/device/pair_rows.hpp"
#include "backend/flow_view.hpp"
#include "physics/pair/density.hpp"
#include "physics/pair/forces.hpp"
#include "physics/pair/strain_rate.hpp"

// The sums over pairs of the method of the paper, one particle at a time, in single precision.

namespace sabo {

/// What all sums over pairs know.
struct PairSums {
  PairScale scale;
  PairRows rows;
  std::size_t fluid_count;

  SABO_HD WendlandC2<float> kernel() const { return {scale.h, scale.kernel_alpha}; }

  /// x_i - x_j from integer positions; on periodic axes the nearest image.
  template <class I, class J>
  SABO_HD Vec3f separation(const I& i, const J& j) const {
    using std::rint;
    Vec3f x = scale.unit * Vec3f{float(difference(i.x, j.x)), float(difference(i.y, j.y)),
                                 float(difference(i.z, j.z))};
    if (scale.periodic) {
      x -= rint(x.x * scale.inverse_period[0]) * scale.period[0];
      x -= rint(x.y * scale.inverse_period[1]) * scale.period[1];
      x -= rint(x.z * scale.inverse_period[2]) * scale.period[2];
    }
    return x;
  }
  template <class Record>
  SABO_HD PairGeometry<float> geometry(const Record& i, const Record& j) const {
    return pair_geometry(separation(i, j), kernel());
  }

  SABO_HD DensityDiffusion<float> diffusion(const Vec3f& background) const {
    return {scale.two_zeta_h_c0, scale.eta2, background};
  }
  SABO_HD float mass(const MotionRecord& of) const {
    return of.volume * (scale.rho0 + scale.rho0 * of.excess);
  }
  template <class Record>
  SABO_HD static Vec3f velocity(const Record& of) {
    return {of.vx, of.vy, of.vz};
  }
};

/// Strain rate and density rate of all particles.
struct MotionSweep {
  PairSums pairs;
  const MotionRecord* records;
  Sym3<double>* strain;
  double* density_rate;
  double* diffusion_rate;  ///< of the fluid

  struct Sums {
    Sym3<float> eps;
    float rate = 0, diffused = 0;
    SABO_HD void join(const Sums& other) {
      eps += other.eps;
      rate += other.rate;
      diffused += other.diffused;
    }
  };

  SABO_HD Sums sums_of(std::size_t i, RowShare share) const {
    const PairScale& scale = pairs.scale;
    const MotionRecord me = records[i];
    const Vec3f velocity = PairSums::velocity(me);
    const bool is_fluid = i < pairs.fluid_count;
    const auto diffusion = pairs.diffusion(
        scale.hydrostatic - scale.hydrostatic_slope * scale.from_origin(me.x, me.y, me.z));
    const std::uint32_t fluid = pairs.rows.fluid[i], count = pairs.rows.count[i];
    Sums sums;
    for (std::uint32_t k = share.first; k < count; k += share.stride) {
      const MotionRecord j = records[pairs.rows.at(i, k)];
      const auto pair = pairs.geometry(me, j);
      const Vec3f v = velocity - PairSums::velocity(j);
      const float mass = pairs.mass(j);
      const bool across_wall = is_fluid != (k < fluid);
      const float wall = across_wall ? scale.wall_velocity_factor : 1.0f;
      sums.rate += continuity(pair, v, mass);
      if (is_fluid && !across_wall) sums.diffused += diffusion(pair, me.excess, j.excess, mass);
      sums.eps += strain_rate(pair, wall * v, j.volume);
    }
    return sums;
  }
  SABO_HD void finish(std::size_t i, const Sums& sums) const {
    strain[i] = in_double(sums.eps);
    density_rate[i] = sums.rate + sums.diffused;
    if (i < pairs.fluid_count) diffusion_rate[i] = sums.diffused;
  }
};

/// Acceleration by the body force, pressure and viscosity, and the power of pressure. The switches
/// that cost most are known when it is compiled.
template <bool two_point, bool artificial>
struct ForceSweep {
  PairSums pairs;
  const StressRecord* records;
  FlowView flow;

  struct Sums {
    Vec3f acceleration;
    float power = 0, wall_heat = 0;
    SABO_HD void join(const Sums& other) {
      acceleration += other.acceleration;
      power += other.power;
      wall_heat += other.wall_heat;
    }
  };

  SABO_HD Sums sums_of(std::size_t i, RowShare share) const {
    const PairScale& scale = pairs.scale;
    const StressRecord me = records[i];
    const Vec3f velocity = PairSums::velocity(me);
    const std::uint32_t fluid = pairs.rows.fluid[i], count = pairs.rows.count[i];
    Sums sums;
    Vec3f& a = sums.acceleration;
    for (std::uint32_t k = share.first; k < count; k += share.stride) {
      const StressRecord j = records[pairs.rows.at(i, k)];
      const auto pair = pairs.geometry(me, j);
      a += stress_force(pair, stress(me), stress(j), j.mass);
      sums.power += pressure_power(pair, velocity, me.pressure, j.pressure, j.mass);
      if (k >= fluid)
        sums.wall_heat +=
            pressure_loss(pair, velocity, PairSums::velocity(j), me.pressure, j.pressure, j.mass);
      const Vec3f v = velocity - PairSums::velocity(j);
      if constexpr (two_point) {
        const float mu = k < fluid ? pair_viscosity(me.viscosity, j.viscosity)
                                   : scale.wall_velocity_factor * me.viscosity;
        a += morris_force(pair, v, mu, j.mass / (me.density * j.density), scale.eta2);
      }
      if constexpr (artificial)
        a += artificial_viscosity(pair, v, scale.alpha_c0_h, 2 * j.mass / (me.density + j.density),
                                  scale.eta2)
                 .acceleration;
    }
    return sums;
  }
  SABO_HD void finish(std::size_t i, const Sums& sums) const {
    flow.acceleration[i] =
        flow.model.body_force(flow.fluid.position[i]) + in_double(sums.acceleration);
    flow.pressure_power[i] = sums.power;
    flow.wall_heat[i] = sums.wall_heat;
  }

 private:
  SABO_HD static Sym3<float> stress(const StressRecord& of) {
    return {of.xx, of.xy, of.xz, of.yy, of.yz, of.zz};
  }
};

/// Records of all particles of one set.
struct PackMotion {
  RecordPacker pack;
  ParticleView of;
  std::size_t offset;
  MotionRecord* records;
  SABO_HD void operator()(std::size_t i) const {
    records[offset + i] = pack.motion(of, i, pack.place(of.position[i]));
  }
};
struct PackStress {
  RecordPacker pack;
  ParticleView of;
  std::size_t offset;
  const Sym3<double>* stress;
  const MotionRecord* motion;
  StressRecord* records;
  SABO_HD void operator()(std::size_t i) const {
    const std::size_t at = offset + i;
    records[at] = pack.stress(of, i, stress[at], motion[at]);
  }
};

}  // namespace sabo
