#include "backend/reference/reference_backend.hpp"

#include "physics/pair/density.hpp"
#include "physics/pair/forces.hpp"
#include "physics/pair/strain_rate.hpp"

namespace sabo {
namespace {

FlowModel serial(FlowModel model) {
  model.threads = 1;
  return model;
}

}  // namespace

ReferenceBackend::ReferenceBackend(const FlowModel& model) : HostBackend(serial(model)) {}

const Vec3d& ReferenceBackend::position(std::size_t k) const {
  return k < fluid_.size() ? fluid_.position[k] : boundary_.position[k - fluid_.size()];
}
const Vec3d& ReferenceBackend::velocity(std::size_t k) const {
  return k < fluid_.size() ? fluid_.velocity[k] : boundary_.velocity[k - fluid_.size()];
}
double ReferenceBackend::density(std::size_t k) const {
  return k < fluid_.size() ? fluid_.density[k] : boundary_.density[k - fluid_.size()];
}
double ReferenceBackend::mass(std::size_t k) const {
  return k < fluid_.size() ? fluid_.mass[k] : boundary_.mass[k - fluid_.size()];
}

double ReferenceBackend::pressure_of(std::size_t k) const {
  return k < fluid_.size() ? fluid_.pressure[k] : boundary_.pressure[k - fluid_.size()];
}
double ReferenceBackend::pressure_term(std::size_t k) const {
  return pressure_of(k) / (density(k) * density(k));
}

void ReferenceBackend::list_pairs() {
  has_neighbours_.assign(fluid_.size(), 0);
  for (std::size_t i = 0; i < fluid_.size(); ++i)
    for_each_neighbour(i, false, [&](std::size_t, const auto&) { has_neighbours_[i] = 1; });
  list_awake();
  prepare_rows();
}

void ReferenceBackend::prepare_rows() { velocity_step_.reset(on_, fluid_.size()); }

void ReferenceBackend::fluid_near(std::size_t i, std::vector<std::uint32_t>& near) const {
  for_each_neighbour(
      i, true, [&](std::size_t j, const auto&) { near.push_back(static_cast<std::uint32_t>(j)); });
}

void ReferenceBackend::strain_and_density_rates() {
  const std::size_t fluids = fluid_.size();
  DensityDiffusion<double> diffusion{
      2 * model_.density_diffusion * model_.h * model_.state.c0, model_.eta2(), {}};
  const double rho0 = model_.state.rho0;
  for (std::size_t i = 0; i < fluids + boundary_.size(); ++i) {
    const bool is_fluid = i < fluids;
    diffusion.hydrostatic = model_.diffusion_background(position(i));
    Sym3<double> eps{};
    double rate = 0, diffusion_rate = 0;
    for_each_neighbour(i, !is_fluid, [&](std::size_t j, const PairGeometry<double>& pair) {
      const Vec3d v = velocity(i) - velocity(j);
      const bool across_wall = is_fluid != (j < fluids);
      const double wall = across_wall ? model_.wall_velocity_factor() : 1;
      eps += strain_rate(pair, wall * v, mass(j) / density(j));
      rate += continuity(pair, v, mass(j));
      if (is_fluid && !across_wall)
        diffusion_rate += diffusion(pair, density(i) / rho0 - 1, density(j) / rho0 - 1, mass(j));
    });
    strain_[i] = eps;
    density_rate_[i] = rate + diffusion_rate;
    if (is_fluid) diffusion_rate_[i] = diffusion_rate;
  }
}

void ReferenceBackend::momentum() {
  const std::size_t fluids = fluid_.size();
  const bool morris = model_.viscous_operator == ViscousOperator::morris;
  const double alpha_c0_h = model_.artificial_viscosity * model_.state.c0 * model_.h;
  for (std::size_t i = 0; i < fluids; ++i) {
    Vec3d a = model_.body_force(position(i));
    double power = 0, wall_heat = 0;
    for_each_neighbour(i, false, [&](std::size_t j, const PairGeometry<double>& pair) {
      const Vec3d v = velocity(i) - velocity(j);
      a += stress_force(pair, stress_[i], stress_[j], mass(j));
      power += pressure_power(pair, velocity(i), pressure_term(i), pressure_term(j), mass(j));
      if (j >= fluids)
        wall_heat += pressure_loss(pair, velocity(i), velocity(j), pressure_term(i),
                                   pressure_term(j), mass(j));
      if (morris) {
        const double mu = j < fluids ? pair_viscosity(fluid_.viscosity[i], fluid_.viscosity[j])
                                     : model_.wall_velocity_factor() * fluid_.viscosity[i];
        a += morris_force(pair, v, model_.strain_convention() * mu,
                          mass(j) / (density(i) * density(j)), model_.eta2());
      }
      const double mean_density = 0.5 * (density(i) + density(j));
      a += artificial_viscosity(pair, v, alpha_c0_h, mass(j) / mean_density, model_.eta2())
               .acceleration;
    });
    acceleration_[i] = a;
    pressure_power_[i] = power;
    wall_heat_[i] = wall_heat;
  }
  load_bodies_by_stress();
  hold_driven();
}

}  // namespace sabo
