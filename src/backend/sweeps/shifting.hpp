#pragma once

#include <algorithm>

#include "backend/flow_view.hpp"
#include "backend/records.hpp"
#include "physics/pair/strain_rate.hpp"

// Particle shifting of the implicit method: inside of a flow that strains for long, particles
// gather in filaments and leave others bare. So they are moved down the gradient of the filling of
// their kernel (Fick's law; Lind, Xu, Stansby & Rogers 2012), with the diffusivity over a step
//   D = h^2 min(1/2, a |shear rate| dt).
// One half is the limit of stability, which Lind et al. take in every step. With the strain of the
// step places even out as fast as the flow disturbs them, whatever the length of the step, and a
// deposit is left alone. Mass and momentum stay with the particles.

namespace sabo {

/// The shift of a particle over the step.
struct FindShift {
  static constexpr double most_diffusivity = 0.5;  // over a step, of h^2
  static constexpr double most_shift = 0.1;        // of the spacing
  // Filled share of the kernel from which on a particle begins to count as inside. Near a free
  // surface the gradient of the filling shows the way out.
  static constexpr double inside_from = 0.95;

  FlowView flow;
  double dt;

  SABO_HD void operator()(std::size_t i) const {
    const double h = flow.model.h;
    const double inside = std::clamp((flow.support[i] - inside_from) / (1 - inside_from), 0.0, 1.0);
    const double strain = shear_rate(flow.strain[i]) * dt;
    const double wanted = flow.model.particle_shifting * strain;
    const double diffusivity = inside * h * h * smaller(wanted, most_diffusivity);
    const Vec3d shift = -diffusivity * flow.filling[i].gradient;
    const double most = most_shift * flow.model.spacing;
    const double size = norm(shift);
    flow.shift[i] = {size > most ? (most / size) * shift : shift, 0};
  }
};

/// Adds what the shifts of a particle and of its neighbours change in the filling of its kernel to
/// its density rate: sum of V_j (s_i - s_j) . grad W, of which `near` is the sum of V_j s_j . grad
/// W over the fluid. Continuity sees the flow alone, whose disorder fills kernels on average;
/// without what shifting takes back from them density would creep up.
struct FillByShifts {
  FlowView flow;
  double dt;

  SABO_HD void operator()(std::size_t i, double near) const {
    Shift& shift = flow.shift[i];
    shift.filled = dot(shift.by, flow.filling[i].gradient) - near;
    flow.density_rate[i] += flow.model.state.rho0 / dt * shift.filled;
  }
};

/// Makes of a record of motion at the same place one of the shift.
struct PackShift {
  FlowView flow;
  MotionRecord* records;

  SABO_HD void operator()(std::size_t i) const {
    MotionRecord& record = records[i];
    const Vec3d& shift = flow.shift[i].by;
    record.vx = float(shift.x);
    record.vy = float(shift.y);
    record.vz = float(shift.z);
    record.volume = float(flow.fluid.mass[i] / flow.model.state.rho0);
  }
};

struct MoveByShift {
  FlowView flow;
  SABO_HD void operator()(std::size_t i) const { flow.fluid.position[i] += flow.shift[i].by; }
};

}  // namespace sabo
