#include <algorithm>

#include "backend/reference/reference_backend.hpp"
#include "backend/sweeps/shifting.hpp"
#include "physics/pair/density.hpp"
#include "physics/pair/forces.hpp"
#include "physics/pair/strain_rate.hpp"
#include "physics/pair/wall_contact.hpp"

// The pair sweeps of the implicit method.

namespace sabo {

void ReferenceBackend::wall_pressure() {
  extrapolate_to_boundary();
  for (std::size_t b = 0; b < boundary_.size(); ++b)
    boundary_.pressure[b] = model_.state.pressure(boundary_.density[b]);
}

void ReferenceBackend::near_forces() {
  const std::size_t fluids = fluid_.size();
  const auto kernel = model_.kernel<double>();
  const double rho0 = model_.state.rho0, two_point_scale = model_.two_point_scale();
  const double alpha_c0_h = model_.artificial_viscosity * model_.state.c0 * model_.h;
  for (const std::uint32_t i : awake_) {
    Vec3d a = model_.body_force(position(i));
    double conductance = 0, artificial_heat = 0;
    Sym3<double> moments{};
    Filling filling{kernel.value(0) * mass(i) / rho0, {}};
    WallShare wall;
    for_each_neighbour(i, false, [&](std::size_t j, const PairGeometry<double>& pair) {
      a += pressure_force(pair, pressure_of(i) / (rho0 * rho0), pressure_of(j) / (rho0 * rho0),
                          mass(j));
      const double volume = mass(j) / rho0;
      filling.share += volume * kernel.value(std::sqrt(pair.r2));
      filling.gradient += (volume * pair.gradient) * pair.x;
      if (j < fluids) {
        // Not at walls, whose shear is that of their law.
        const double mean_density = 0.5 * (density(i) + density(j));
        const auto artificial = artificial_viscosity(pair, velocity(i) - velocity(j), alpha_c0_h,
                                                     mass(j) / mean_density, model_.eta2());
        a += artificial.acceleration;
        artificial_heat += artificial.heat;
        const double mu = pair_viscosity(fluid_.viscosity[i], fluid_.viscosity[j]);
        const double pair_conductance =
            viscous_conductance(pair, two_point_scale * mu, mass(i) / rho0, volume);
        conductance += pair_conductance;
        moments += scaled_square(pair_conductance, pair.x);
      } else {
        const double part = volume * kernel.value(std::sqrt(pair.r2));
        wall.share += part;
        wall.gradient += (volume * pair.gradient) * pair.x;
        wall.velocity += part * velocity(j);
      }
    });
    acceleration_[i] = a;
    velocity_step_.conductance_sum[i] = conductance;
    if (model_.whole_viscous_stress)  // else zero
      velocity_step_.inverse_root[i] = inverse_root(moments, model_.dimension);
    artificial_heat_[i] = artificial_heat;
    filling_[i] = filling;
    wall_share_[i] = wall;
  }
  load_bodies_by_pressure();
}

ViscousSolve ReferenceBackend::advance_velocity(const VelocityTolerance& tolerance,
                                                int most_iterations) {
  const double rho0 = model_.state.rho0, two_point_scale = model_.two_point_scale();
  auto& solver = velocity_step_.solver;
  std::vector<VelocityGradient<double>> gradients(fluid_.size());  // halves
  /// f(j, a, v, x) for the fluid j near i: conductance, differences of direction and place.
  const auto over_pairs = [&](std::uint32_t i, const auto& f) {
    const Quad<double>& p = solver.direction[i];
    for_each_neighbour(i, true, [&](std::size_t j, const PairGeometry<double>& pair) {
      const double mu = pair_viscosity(fluid_.viscosity[i], fluid_.viscosity[j]);
      const double a =
          viscous_conductance(pair, two_point_scale * mu, mass(i) / rho0, mass(j) / rho0);
      const Quad<double>& pj = solver.direction[j];
      f(j, a, Vec3d{p.x - pj.x, p.y - pj.y, p.z - pj.z}, pair.x);
    });
  };
  const auto find_gradients = [&] {
    for (const std::uint32_t i : awake_) {
      VelocityGradient<double> sum;
      over_pairs(i, [&](std::size_t, double a, const Vec3d& v, const Vec3d& x) {
        sum += outer_product(v, a * x);
      });
      gradients[i] = half_gradient(sum, velocity_step_.inverse_root[i]);
    }
  };
  const auto multiply = [&](const double* masses, const double* drag,
                            const SolveProgress<double>*) {
    find_gradients();
    Total sum;
    for (const std::uint32_t i : awake_) {
      const Quad<double>& p = solver.direction[i];
      Vec3d flow = drag[i] * Vec3d{p.x, p.y, p.z};
      over_pairs(i, [&](std::size_t j, double a, const Vec3d& v, const Vec3d& x) {
        flow += a * (v + transposed_times(gradients[i], x) + transposed_times(gradients[j], x));
      });
      const Vec3d q = masses[i] * Vec3d{p.x, p.y, p.z} + step_.dt * flow;
      solver.product[i] = {q.x, q.y, q.z};
      sum.join({p.x * q.x + p.y * q.y + p.z * q.z});
    }
    solver.curvature[0] = sum;
  };
  return velocity_step_.advance(on_, view(), {awake_.data(), awake_.size()},
                                {driven_.data(), driven_.size()}, &step_, tolerance,
                                most_iterations, multiply, EnterHeat{&heat_});
}

ReferenceBackend::Closing ReferenceBackend::closing_on(std::size_t b) const {
  if (!(boundary_.pressure[b] > 0)) return {};
  const auto kernel = model_.kernel<double>();
  double weight = 0;
  Closing sum;
  for_each_neighbour(fluid_.size() + b, true, [&](std::size_t j, const PairGeometry<double>& pair) {
    weight += kernel.value(std::sqrt(pair.r2));
    sum.rate += closing(pair, boundary_.velocity[b] - velocity(j));
    sum.gradient += pair.gradient * pair.x;
  });
  return weight > 0 ? Closing{sum.rate / weight, (1 / weight) * sum.gradient} : Closing{};
}

void ReferenceBackend::near_motion() {
  const std::size_t fluids = fluid_.size();
  load_bodies_by_friction();
  find_diffusion_background();
  DensityDiffusion<double> diffusion{
      2 * model_.density_diffusion * model_.h * model_.state.c0, model_.eta2(), {}};
  const double rho0 = model_.state.rho0;
  const auto kernel = model_.kernel<double>();
  std::vector<Closing> closing_on_wall(boundary_.size());
  for (std::size_t b = 0; b < boundary_.size(); ++b) closing_on_wall[b] = closing_on(b);
  for (const std::uint32_t i : awake_) {
    Sym3<double> eps{};
    double rate = 0, diffusion_rate = 0, wall_rate = 0;
    double support = 0;
    diffusion.hydrostatic = background_[i];
    const WallGrip& grip = wall_grip_[i];
    const Vec3d normal = norm(grip.slope) > 0 ? normalised(grip.slope) : grip.slope;
    const double slides = 1 - grip.held;
    for_each_neighbour(i, false, [&](std::size_t j, const PairGeometry<double>& pair) {
      const Vec3d v = velocity(i) - velocity(j);
      const double volume = mass(j) / density(j);
      support -= volume * pair.gradient * pair.r2 / model_.dimension;
      if (j < fluids) {
        rate += continuity(pair, v, mass(j));
        diffusion_rate += diffusion(pair, density(i) / rho0 - 1, density(j) / rho0 - 1, mass(j));
        eps += strain_rate(pair, v, volume);
      } else {
        const double weight = kernel.value(std::sqrt(pair.r2));
        const Closing& c = closing_on_wall[j - fluids];
        const Vec3d past = along(v, normal);
        wall_rate +=
            continuity(pair, v, mass(j)) + handed_back(mass(j) * weight, past, c.rate, c.gradient);
        eps +=
            strain_rate(pair, std::max(0.0, dot(grip.slope, pair.x)) * (v - slides * past), volume);
      }
    });
    strain_[i] = (1 / std::max(least_support, support)) * eps;
    diffusion_rate_[i] = diffusion_rate;
    density_rate_[i] = rate + diffusion_rate + one_sided(wall_rate, density(i) / rho0 - 1);
    support_[i] = support;
  }
}

void ReferenceBackend::fill_by_shifts(double dt) {
  const FillByShifts fill{view(), dt};
  for (const std::uint32_t i : awake_) {
    double near = 0;
    for_each_neighbour(i, true, [&](std::size_t j, const PairGeometry<double>& pair) {
      near += mass(j) / model_.state.rho0 * pair.gradient * dot(shift_[j].by, pair.x);
    });
    fill(i, near);
  }
}

}  // namespace sabo
