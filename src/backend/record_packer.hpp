#pragma once

#include <cmath>
#include <cstdint>

#include "backend/pair_scale.hpp"
#include "backend/records.hpp"
#include "math/sym3.hpp"
#include "particles/particle_view.hpp"

namespace sabo {

/// Makes the records of the pair sweeps from the state.
struct RecordPacker {
  Vec3d centre;
  double per_unit;  ///< 1/m
  double rho0;
  double strain_convention;
  double two_point_scale;  ///< on the viscosity of the implicit method

  RecordPacker(const FlowModel& model, const Vec3d& place_of_zero, const PairScale& scale)
      : centre(place_of_zero),
        per_unit(1.0 / scale.unit),
        rho0(model.state.rho0),
        strain_convention(model.strain_convention()),
        two_point_scale(scale.two_point_scale) {}

  SABO_HD IntegerPlace place(const Vec3d& position) const {
    using std::lrint;
    const Vec3d x = per_unit * (position - centre);
    return {static_cast<std::int32_t>(lrint(x.x)), static_cast<std::int32_t>(lrint(x.y)),
            static_cast<std::int32_t>(lrint(x.z))};
  }

  SABO_HD MotionRecord motion(const ParticleView& of, std::size_t i, const IntegerPlace& at) const {
    const Vec3d& v = of.velocity[i];
    return {at.x,
            at.y,
            at.z,
            float(v.x),
            float(v.y),
            float(v.z),
            float(of.density[i] / rho0 - 1),
            float(of.mass[i] / of.density[i])};
  }

  SABO_HD FlowRecord flow(const ParticleView& of, std::size_t i) const {
    const IntegerPlace at = place(of.position[i]);
    return {at.x,
            at.y,
            at.z,
            float(of.mass[i]),
            float(of.pressure[i] / (rho0 * rho0)),
            float(of.mass[i] / rho0),
            float(two_point_scale * of.viscosity[i]),
            float(of.density[i])};
  }

  SABO_HD StressRecord stress(const ParticleView& of, std::size_t i, const Sym3<double>& s,
                              const MotionRecord& m) const {
    return {m.x,
            m.y,
            m.z,
            float(of.mass[i]),
            float(s.xx),
            float(s.xy),
            float(s.xz),
            float(s.yy),
            float(s.yz),
            float(s.zz),
            m.vx,
            m.vy,
            m.vz,
            float(strain_convention * of.viscosity[i]),
            float(of.density[i]),
            float(of.pressure[i] / (of.density[i] * of.density[i]))};
  }
};

}  // namespace sabo
