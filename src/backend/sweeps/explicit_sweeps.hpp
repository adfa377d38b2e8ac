#pragma once

#include <type_traits>
#include <variant>

#include "backend/chosen_step.hpp"
#include "backend/flow_view.hpp"
#include "math/scalar.hpp"
#include "physics/pair/strain_rate.hpp"
#include "physics/shear_state.hpp"

// What the method of the paper does at one particle at a time.

namespace sabo {

/// Into the primary cell.
struct WrapPosition {
  Periodic periodic;
  Vec3d* position;
  SABO_HD void operator()(std::size_t i) const { position[i] = periodic.wrapped(position[i]); }
};

/// Pressure from density (Eq. 14).
struct FindPressure {
  Tait state;
  ParticleView of;
  SABO_HD void operator()(std::size_t i) const { of.pressure[i] = state.pressure(of.density[i]); }
};

/// Viscosity and stress from strain rate and pressure (Eqs. 17, 21-26); of pressure alone where the
/// particles carry no shear stress.
template <class Law>
struct FindStress {
  FlowView flow;
  Law law;
  ParticleView of;
  std::size_t offset;  ///< of the particles in arrays over all of them
  bool carries_stress;

  SABO_HD void operator()(std::size_t i) const {
    const double convention = flow.model.strain_convention();  // in the shear rate and the stress
    const Sym3<double>& eps = flow.strain[offset + i];
    const double p = of.pressure[i];
    const double gd = convention * shear_rate(eps);
    const double mu = law.viscosity(shear_state<Law>(gd, p, flow.model.yield, flow.yield_slope));
    const double rho2 = of.density[i] * of.density[i];
    of.shear_rate[i] = gd;
    of.viscosity[i] = mu;
    Sym3<double>& stress = flow.stress[offset + i];
    stress = isotropic(-p / rho2);
    if (carries_stress) stress += (convention * mu / rho2) * eps;
  }
};

/// That of all particles, by the model's law; walls carry stress as the model says.
template <class Executor>
void find_stress(const Executor& on, const FlowView& flow, std::size_t boundary_count) {
  const FlowModel& model = flow.model;
  const bool nested = model.viscous_operator == ViscousOperator::nested;
  const bool wall = nested && model.boundary_stress != BoundaryStress::none;
  std::visit(
      [&](const auto& law) {
        using Find = FindStress<std::decay_t<decltype(law)>>;
        on.for_each(flow.fluid_count, Find{flow, law, flow.fluid, 0, nested});
        on.for_each(boundary_count, Find{flow, law, flow.boundary, flow.fluid_count, wall});
      },
      model.rheology);
}

/// State of the fluid and density of the boundary at the start of a step.
struct StepStart {
  Vec3d* position;
  Vec3d* velocity;
  double* density;
  double* boundary_density;
};

/// Half a step with the current rates.
struct PredictFluid {
  FlowView flow;
  const ChosenStep* step;
  SABO_HD void operator()(std::size_t i) const {
    const double half_step = 0.5 * step->dt;
    flow.fluid.position[i] += half_step * flow.fluid.velocity[i];
    flow.fluid.velocity[i] += half_step * flow.acceleration[i];
    flow.fluid.density[i] += half_step * flow.density_rate[i];
  }
};
struct PredictBoundary {
  FlowView flow;
  const ChosenStep* step;
  SABO_HD void operator()(std::size_t b) const {
    double& density = flow.boundary.density[b];
    density = larger(density + 0.5 * step->dt * flow.density_rate[flow.fluid_count + b],
                     flow.model.state.rho0);
  }
};

/// rho(n+1) = rho(n) (2 + k) / (2 - k), k = dt (drho/dt) / rho at the middle: the implicit midpoint
/// of d(ln rho)/dt, which keeps rho positive (Parshikov et al. 2000).
SABO_HD inline double advanced_density(double start, double middle, double rate, double dt) {
  const double k = dt * rate / middle;
  return start * (2 + k) / (2 - k);
}

/// The whole step with the rates at its middle.
struct CorrectFluid {
  FlowView flow;
  StepStart start;
  const ChosenStep* step;
  SABO_HD void operator()(std::size_t i) const {
    const double dt = step->dt;
    const Vec3d velocity = start.velocity[i] + dt * flow.acceleration[i];
    flow.fluid.position[i] = start.position[i] + (0.5 * dt) * (start.velocity[i] + velocity);
    flow.fluid.velocity[i] = velocity;
    flow.fluid.density[i] =
        advanced_density(start.density[i], flow.fluid.density[i], flow.density_rate[i], dt);
  }
};
/// A wall that remembers suction would hold the flow back: boundary density stays at or above its
/// reference (as in dynamic boundary codes since Crespo et al. 2007).
struct CorrectBoundary {
  FlowView flow;
  StepStart start;
  const ChosenStep* step;
  SABO_HD void operator()(std::size_t b) const {
    double& density = flow.boundary.density[b];
    density = larger(advanced_density(start.boundary_density[b], density,
                                      flow.density_rate[flow.fluid_count + b], step->dt),
                     flow.model.state.rho0);
  }
};

}  // namespace sabo
