#pragma once

#include <variant>

#include "backend/device/device_neighbours.hpp"
#include "backend/sweeps/boundary_sweeps.hpp"
#include "backend/sweeps/driven.hpp"
#include "backend/sweeps/explicit_sweeps.hpp"

// The sweeps of the method of the paper, sums over all particles, and loads on bodies.

namespace sabo {

template <class Executor>
void DeviceBackend<Executor>::pressure() {
  const Clock clock(*this, "pressure");
  for (DeviceParticles<Executor>* set : {&fluid_, &boundary_})
    on_.for_each(set->size(), FindPressure{model_.state, set->view()});
  fluid_changed();
  boundary_copy_.outdate();
}

template <class Executor>
void DeviceBackend<Executor>::pack_motion() {
  const Clock clock(*this, "records");
  on_.reserve(motion_, all());
  on_.for_each(fluid_.size(), PackMotion{packer(), fluid_.view(), 0, motion_.data()});
  on_.for_each(boundary_.size(),
               PackMotion{packer(), boundary_.view(), fluid_.size(), motion_.data()});
}

template <class Executor>
void DeviceBackend<Executor>::strain_and_density_rates() {
  need_explicit_arrays();
  pack_motion();
  const Clock clock(*this, "motion sweep", pairs_.all());
  on_.sweep(all(), MotionSweep{pair_sums(), motion_.data(), strain_.data(), density_rate_.data(),
                               diffusion_rate_.data()});
}

template <class Executor>
void DeviceBackend<Executor>::stress() {
  const Clock clock(*this, "stress");
  find_stress(on_, view(), boundary_.size());
  fluid_changed();
  boundary_copy_.outdate();
}

template <class Executor>
void DeviceBackend<Executor>::momentum() {
  {
    const Clock clock(*this, "records");
    on_.reserve(stress_records_, all());
    const auto pack = [&](const ParticleView& of, std::size_t offset) {
      return PackStress{
          packer(), of, offset, stress_.data(), motion_.data(), stress_records_.data()};
    };
    on_.for_each(fluid_.size(), pack(fluid_.view(), 0));
    on_.for_each(boundary_.size(), pack(boundary_.view(), fluid_.size()));
  }
  {
    const Clock clock(*this, "force sweep", pairs_.fluid);
    const auto sweep = [&]<bool two_point, bool artificial>() {
      on_.sweep(fluid_.size(),
                ForceSweep<two_point, artificial>{pair_sums(), stress_records_.data(), view()});
    };
    const bool artificial = model_.artificial_viscosity > 0;
    if (model_.viscous_operator == ViscousOperator::morris)
      artificial ? sweep.template operator()<true, true>()
                 : sweep.template operator()<true, false>();
    else
      artificial ? sweep.template operator()<false, true>()
                 : sweep.template operator()<false, false>();
  }
  if (!body_loads_.loads().empty()) {
    on_.zero(row_forces_, body_rows_.size());
    add_to_bodies(StressOnBody{view()});
  }
  hold_driven();
}

template <class Executor>
void DeviceBackend<Executor>::hold_driven() {
  over_driven(HoldDriven{view()});
  hold_walls();
}

template <class Executor>
void DeviceBackend<Executor>::hold_walls() {
  if (driven_walls_.size() == 0) return;
  using Hold = HoldWall<RowNear>;
  on_.for_each(driven_walls_.size(), AtRow<Hold>{driven_walls_.data(), {view(), RowNear{rows()}}});
  boundary_copy_.outdate();
}

template <class Executor>
void DeviceBackend<Executor>::extrapolate_to_boundary() {
  const Clock clock(*this, "start of the boundary");
  on_.for_each(boundary_.size(), ExtrapolateToBoundary<RowNear>{view(), RowNear{rows()}});
  boundary_copy_.outdate();
}

/// Adds force(i, b, pair) on boundary particle b by each fluid particle i near it, N.
template <class Executor>
template <class PairForce>
void DeviceBackend<Executor>::add_to_bodies(const PairForce& force) {
  const Clock clock(*this, "bodies");
  using Add = AddToBody<RowNear, PairForce>;
  on_.for_each(body_rows_.size(),
               Add{view(), RowNear{rows()}, body_rows_.data(), force, row_forces_.data()});
  on_.start_download(row_forces_, row_forces_copy_);
  new_forces_then_.emplace(on_.now());
}

/// With what has been added since the last time, which is waited for here.
template <class Executor>
BodyLoadSum& DeviceBackend<Executor>::fetched_loads() const {
  if (!new_forces_then_) return body_loads_;
  on_.await(*new_forces_then_);
  new_forces_then_.reset();
  body_loads_.sum({row_forces_copy_.data(), row_forces_copy_.size()});
  return body_loads_;
}

/// The sweeps go on with what is on the device; the host gets a copy, which it does not wait for.
template <class Executor>
void DeviceBackend<Executor>::choose_step(const StepRule& rule, double longest) {
  const Clock clock(*this, "checks and sums");
  const FindFastest find{awake(),
                         driven(),
                         has_neighbours_.data(),
                         fluid_.velocity.data(),
                         acceleration_.data(),
                         fluid_.viscosity.data(),
                         fluid_.density.data()};
  std::visit(
      [&](const auto& by) {
        using Choose = ChooseStep<std::decay_t<decltype(by)>>;
        on_.template sum_up<Fastest>(awake_.size() + driven_.size(), find,
                                     Choose{by, longest, step_.data()});
      },
      rule);
  on_.start_download(step_, step_copy_);
  step_then_.emplace(on_.now());
}

template <class Executor>
ChosenStep DeviceBackend<Executor>::chosen_step() const {
  if (!step_then_) return {};
  on_.await(*step_then_);
  return *step_copy_.data();
}

template <class Executor>
FlowHealth DeviceBackend<Executor>::health() const {
  const Condition& condition = state_sums().condition;
  return {condition.lowest, condition.highest, condition.broken == 0};
}

template <class Executor>
double DeviceBackend<Executor>::fastest() const {
  return std::sqrt(state_sums().speed2);
}

/// Of the fluid as it is on the device.
template <class Executor>
const StateSums& DeviceBackend<Executor>::state_sums() const {
  if (state_sums_) return *state_sums_;
  const Clock clock(*this, "checks and sums");
  const FindCondition condition{fluid_.position.data(), fluid_.velocity.data(),
                                fluid_.density.data(), model_.state.rho0};
  const bool is_listed = has_list_ && list_position_.size() == fluid_.size();
  const FindStateSums find{condition,
                           {fluid_.position.data(), is_listed ? list_position_.data() : nullptr},
                           is_listed ? has_neighbours_.data() : nullptr};
  state_sums_ = on_.template reduce<StateSums>(fluid_.size(), find);
  return *state_sums_;
}

template <class Executor>
const HeatAccount& DeviceBackend<Executor>::heat() const {
  on_.download(account_, account_copy_);
  return account_copy_.front();
}

template <class Executor>
void DeviceBackend<Executor>::predict() {
  const Clock clock(*this, "integration");
  on_.copy(fluid_.position, start_position_);
  on_.copy(fluid_.velocity, start_velocity_);
  on_.copy(fluid_.density, start_density_);
  on_.copy(boundary_.density, start_boundary_density_);
  on_.for_each(fluid_.size(), PredictFluid{view(), step_.data()});
  on_.for_each(boundary_.size(), PredictBoundary{view(), step_.data()});
  fluid_changed();
  boundary_copy_.outdate();
}

template <class Executor>
void DeviceBackend<Executor>::correct() {
  const Clock clock(*this, "integration");
  enter<ExplicitHeat>(fluid_.size(), FindExplicitHeat{view(), step_.data()});
  const StepStart start{start_position_.data(), start_velocity_.data(), start_density_.data(),
                        start_boundary_density_.data()};
  on_.for_each(fluid_.size(), CorrectFluid{view(), start, step_.data()});
  on_.for_each(boundary_.size(), CorrectBoundary{view(), start, step_.data()});
  fluid_changed();
  boundary_copy_.outdate();
}

template <class Executor>
std::size_t DeviceBackend<Executor>::device_bytes() const {
  return fluid_.bytes() + boundary_.bytes() + velocity_step_.bytes() +
         half_gradient_.size() * sizeof(VelocityGradient<float>) +
         bytes_of(half_space_, slice_starts_, entries_, fluid_neighbours_, neighbours_,
                  list_position_, awake_, touched_, driven_, driven_walls_, has_neighbours_,
                  strain_, density_rate_, acceleration_, motion_) +
         bytes_of(stress_, pressure_power_, wall_heat_, stress_records_, start_position_,
                  start_velocity_, start_density_, start_boundary_density_) +
         bytes_of(wall_share_, filling_, wall_drag_, support_, wall_grip_, background_, shift_,
                  artificial_heat_, diffusion_rate_, flow_records_, wall_weight_, closings_) +
         bytes_of(body_rows_, row_forces_, sorted_fluid_.first);
}

template <class Executor>
const std::vector<Vec3d>& DeviceBackend<Executor>::accelerations() const {
  on_.download(acceleration_, accelerations_copy_);
  return accelerations_copy_;
}

template <class Executor>
const std::vector<double>& DeviceBackend<Executor>::density_rates() const {
  on_.download(density_rate_, density_rates_copy_);
  return density_rates_copy_;
}

}  // namespace sabo
