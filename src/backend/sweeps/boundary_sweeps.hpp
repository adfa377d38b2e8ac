#pragma once

#include <cmath>

#include "backend/body_load.hpp"
#include "backend/flow_view.hpp"
#include "physics/pair/forces.hpp"

// What boundary particles do with the fluid near them, in double precision. `near(i, f)` calls f(j)
// for the fluid near particle i, boundary particles counting from the last fluid one.

namespace sabo {

/// Density of a boundary particle from the pressure of the fluid near it, see
/// Backend::extrapolate_to_boundary().
template <class Near>
struct ExtrapolateToBoundary {
  FlowView flow;
  Near near;

  SABO_HD void operator()(std::size_t b) const {
    const auto kernel = flow.model.template kernel<double>();
    const Vec3d at = flow.boundary.position[b];
    const Vec3d force = flow.model.body_force(at);
    double weight = 0;
    double pressure = 0;
    near(flow.fluid_count + b, [&](std::size_t j) {
      const Vec3d x = flow.model.periodic.nearest(at - flow.fluid.position[j]);
      const double w = kernel.value(norm(x));
      weight += w;
      pressure += w * (flow.fluid.pressure[j] + flow.fluid.density[j] * dot(force, x));
    });
    if (weight > 0)
      flow.boundary.density[b] = flow.model.state.density(larger(pressure / weight, 0.0));
  }
};

// What the fluid does to bodies: minus what the pairs with their particles do to the fluid. Summed
// by the particles of the bodies, which are few, so that the sweeps over the fluid know nothing of
// it; a force acts at the particle of the body.

/// Whether a boundary particle belongs to a body.
struct BelongsToBody {
  ParticleView boundary;
  SABO_HD bool operator()(std::size_t b) const { return boundary.body[b] != 0; }
};

/// The k-th boundary particle of a body, without a force.
struct FindBodyParticle {
  ParticleView boundary;
  const std::uint32_t* rows;
  BodyForce* particles;
  SABO_HD void operator()(std::size_t k) const {
    const std::size_t b = rows[k];
    const bool is_foundation = (boundary.body[b] & foundation_mark) != 0;
    const auto number = static_cast<std::uint16_t>(boundary.body[b] & most_bodies);
    particles[k] = {number, is_foundation, boundary.position[b], {}};
  }
};

/// To the force on the k-th boundary particle of a body, N: the sum of force(i, b, pair) over the
/// fluid i near it.
template <class Near, class PairForce>
struct AddToBody {
  FlowView flow;
  Near near;
  const std::uint32_t* rows;
  PairForce force;
  Vec3d* sums;

  SABO_HD void operator()(std::size_t k) const {
    const auto kernel = flow.model.template kernel<double>();
    const std::size_t b = rows[k];
    Vec3d sum;
    near(flow.fluid_count + b, [&](std::size_t i) {
      const Vec3d x =
          flow.model.periodic.nearest(flow.fluid.position[i] - flow.boundary.position[b]);
      sum += force(i, b, pair_geometry(x, kernel));
    });
    sums[k] += sum;
  }
};

/// By the pair terms of momentum().
struct StressOnBody {
  FlowView flow;
  SABO_HD Vec3d operator()(std::size_t i, std::size_t b, const PairGeometry<double>& pair) const {
    const FlowModel& model = flow.model;
    const double mass = flow.boundary.mass[b];
    const Vec3d v = flow.fluid.velocity[i] - flow.boundary.velocity[b];
    Vec3d a = stress_force(pair, flow.stress[i], flow.stress[flow.fluid_count + b], mass);
    if (model.viscous_operator == ViscousOperator::morris) {
      const double factor = model.strain_convention() * model.wall_velocity_factor();
      const double densities = flow.fluid.density[i] * flow.boundary.density[b];
      a += morris_force(pair, v, factor * flow.fluid.viscosity[i], mass / densities, model.eta2());
    }
    const double alpha_c0_h = model.artificial_viscosity * model.state.c0 * model.h;
    const double mean_density = 0.5 * (flow.fluid.density[i] + flow.boundary.density[b]);
    a += artificial_viscosity(pair, v, alpha_c0_h, mass / mean_density, model.eta2()).acceleration;
    return -flow.fluid.mass[i] * a;
  }
};

/// By the pressure of near_forces().
struct PressureOnBody {
  FlowView flow;
  SABO_HD Vec3d operator()(std::size_t i, std::size_t b, const PairGeometry<double>& pair) const {
    const double per_rho2 = 1 / (flow.model.state.rho0 * flow.model.state.rho0);
    const Vec3d a = pressure_force(pair, per_rho2 * flow.fluid.pressure[i],
                                   per_rho2 * flow.boundary.pressure[b], flow.boundary.mass[b]);
    return -flow.fluid.mass[i] * a;
  }
};

/// By the wall law, with the new velocities. What holds a particle is shared out among the boundary
/// particles by which it knows of the wall, as its share of the wall is.
struct FrictionOnBody {
  FlowView flow;
  SABO_HD Vec3d operator()(std::size_t i, std::size_t b, const PairGeometry<double>& pair) const {
    const WallShare& wall = flow.wall[i];
    if (!(flow.wall_drag[i] > 0)) return Vec3d{};
    const auto kernel = flow.model.template kernel<double>();
    const double part = flow.boundary.mass[b] / flow.model.state.rho0 *
                        kernel.value(std::sqrt(pair.r2)) / wall.share;
    return part * flow.wall_drag[i] * (flow.fluid.velocity[i] - (1 / wall.share) * wall.velocity);
  }
};

}  // namespace sabo
