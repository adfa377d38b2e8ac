#pragma once

#include "backend/sweeps/boundary_sweeps.hpp"
#include "physics/shear_state.hpp"

// Driven particles (Particles::driven) and the walls near them.

namespace sabo {

struct IsDriven {
  const std::uint16_t* driven;
  SABO_HD bool operator()(std::size_t i) const { return driven[i] != 0; }
};

/// Pressure and effective viscosity from the density and the shear rate that are given.
template <class Law>
struct SettleDriven {
  FlowView flow;
  Law law;
  SABO_HD void operator()(std::size_t i) const {
    const ParticleView& fluid = flow.fluid;
    const double p = flow.model.state.pressure(fluid.density[i]);
    const double gd = flow.model.strain_convention() * fluid.shear_rate[i];
    fluid.pressure[i] = p;
    fluid.viscosity[i] = law.viscosity(shear_state<Law>(gd, p, flow.model.yield, flow.yield_slope));
  }
};

/// Takes the rates away: velocity and density are kept.
struct HoldDriven {
  FlowView flow;
  SABO_HD void operator()(std::size_t i) const {
    flow.acceleration[i] = {};
    flow.density_rate[i] = 0;
  }
};

struct MoveDriven {
  FlowView flow;
  double dt;
  SABO_HD void operator()(std::size_t i) const {
    flow.fluid.position[i] += dt * flow.fluid.velocity[i];
  }
};

/// Whether boundary particle b may have a driven particle near it until pairs are listed anew.
template <class Near>
struct MayTouchDriven {
  FlowView flow;
  Near near;
  SABO_HD bool operator()(std::size_t b) const {
    bool is_one = false;
    near(flow.fluid_count + b,
         [&](std::size_t j) { is_one = is_one || flow.fluid.driven[j] != 0; });
    return is_one;
  }
};

/// Gives boundary particle b the pressure of the fluid near it if some of that is driven. A wall
/// that follows continuity pushes away what comes near it until there is a gap. Driven particles do
/// not give way: the wall under them would end up at a pressure that throws them up once they are
/// free.
template <class Near>
struct HoldWall {
  FlowView flow;
  Near near;
  SABO_HD void operator()(std::size_t b) const {
    bool is_touched = false;
    near(flow.fluid_count + b, [&](std::size_t j) {
      const Vec3d x =
          flow.model.periodic.nearest(flow.boundary.position[b] - flow.fluid.position[j]);
      is_touched =
          is_touched || (flow.fluid.driven[j] != 0 && norm(x) < flow.model.kernel_radius());
    });
    if (!is_touched) return;
    flow.density_rate[flow.fluid_count + b] = 0;
    ExtrapolateToBoundary<Near>{flow, near}(b);
  }
};

}  // namespace sabo
