#pragma once

#include <variant>

#include "backend/device/device_archive.hpp"
#include "backend/device/device_sweeps.hpp"
#include "backend/sweeps/implicit_sweeps.hpp"
#include "backend/sweeps/shifting.hpp"
#include "backend/sweeps/sleep.hpp"

// The sweeps of the implicit method.

namespace sabo {

template <class Executor>
void DeviceBackend<Executor>::wall_pressure() {
  const Clock clock(*this, "wall pressure", swept_.boundary);
  // Zero, since at the edge of the list there may be particles that no sweep packs.
  if (flow_records_.size() != all()) on_.zero(flow_records_, all());
  if (wall_weight_.size() != boundary_.size()) on_.reserve(wall_weight_, boundary_.size());
  on_.for_each(fluid_.size(), PackFlow{packer(), view(), flow_records_.data()});
  sweep_over(touched_, WallPressureSweep{pair_sums(), packer(), view(), flow_records_.data(),
                                         wall_weight_.data()});
  boundary_copy_.outdate();
}

/// All that the sweeps over near particles may meet; after wall_pressure(), which knows the places.
template <class Executor>
void DeviceBackend<Executor>::pack_motion_beside() {
  if (motion_.size() != all()) on_.zero(motion_, all());
  const auto pack = [&](const ParticleView& of, std::size_t offset) {
    return PackMotionBeside{packer(), of, offset, flow_records_.data(), motion_.data()};
  };
  on_.for_each(fluid_.size(), pack(fluid_.view(), 0));
  on_.for_each(touched_.size(),
               AtRow<PackMotionBeside>{touched_.data(), pack(boundary_.view(), fluid_.size())});
}

template <class Executor>
void DeviceBackend<Executor>::near_forces() {
  need_implicit_arrays();
  if (velocity_step_.conductance_sum.size() != fluid_.size()) {
    velocity_step_.reset(on_, fluid_.size());
    if (model_.whole_viscous_stress) on_.zero(half_gradient_, fluid_.size());
  }
  const bool needs_motion = model_.artificial_viscosity > 0 || model_.walls_move;
  if (needs_motion) pack_motion_beside();
  {
    const Clock clock(*this, "force and matrix", swept_.fluid);
    const auto sweep = [&]<bool with_motion>() {
      sweep_over(awake_,
                 NearForceSweep<with_motion>{pair_sums(), flow_records_.data(), motion_.data(),
                                             view(), velocity_step_.conductance_sum.data(),
                                             velocity_step_.inverse_root.data()});
    };
    needs_motion ? sweep.template operator()<true>() : sweep.template operator()<false>();
  }
  if (body_loads_.loads().empty()) return;
  on_.zero(row_forces_, body_rows_.size());
  add_to_bodies(PressureOnBody{view()});
}

template <class Executor>
void DeviceBackend<Executor>::wall_resistance() {
  const Clock clock(*this, "wall law");
  const auto with = [&](const auto& law, const auto& wall_law) {
    using Find = FindWallResistance<std::decay_t<decltype(law)>, std::decay_t<decltype(wall_law)>>;
    over_awake(Find{view(), law, wall_law});
  };
  std::visit(with, model_.rheology, model_.wall);
}

template <class Executor>
ViscousSolve DeviceBackend<Executor>::advance_velocity(const VelocityTolerance& tolerance,
                                                       int most_iterations) {
  const Clock clock(*this, "viscous solve");
  auto& solver = velocity_step_.solver;
  auto* half_gradient = model_.whole_viscous_stress ? half_gradient_.data() : nullptr;
  const auto multiply = [&](const float* mass, const float* drag,
                            const SolveProgress<float>* progress) {
    const ViscousPairs pairs{pair_sums(), flow_records_.data(), solver.direction.data(), progress};
    if (half_gradient != nullptr)
      sweep_over(awake_,
                 HalfGradientSweep{pairs, velocity_step_.inverse_root.data(), half_gradient});
    const ViscousProduct product{pairs, awake_.data(), half_gradient,        mass,
                                 drag,  step_.data(),  solver.product.data()};
    on_.template sweep_and_sum<Total>(awake_.size(), product,
                                      StoreSum<Total>{solver.curvature.data()});
  };
  const ViscousSolve outcome =
      velocity_step_.advance(on_, view(), awake(), driven(), step_.data(), tolerance,
                             most_iterations, multiply, EnterHeat{account_.data()});
  pass_times_["viscous solve"].pairs +=
      (1 + static_cast<std::uint64_t>(outcome.iterations)) * swept_.fluid;
  fluid_changed();
  return outcome;
}

template <class Executor>
void DeviceBackend<Executor>::near_motion() {
  if (!body_loads_.loads().empty()) add_to_bodies(FrictionOnBody{view()});
  if (model_.diffusion_form == DiffusionForm::fourtakas)
    over_awake(FindDiffusionBackground{view()});
  {
    const Clock clock(*this, "wall closing", swept_.boundary);
    pack_motion_beside();
    if (closings_.size() != boundary_.size()) on_.zero(closings_, boundary_.size());
    sweep_over(touched_, WallClosingSweep{pair_sums(), motion_.data(), view(), wall_weight_.data(),
                                          closings_.data()});
  }
  const Clock clock(*this, "near motion", swept_.fluid);
  sweep_over(awake_, NearMotionSweep{pair_sums(), motion_.data(), closings_.data(), view()});
}

/// Before the flow moves them: all sums of the step are of the places that particles have now.
template <class Executor>
void DeviceBackend<Executor>::shift_particles(double dt) {
  const Clock clock(*this, "shifting", swept_.fluid);
  if (!(dt > 0)) return;
  on_.zero(shift_, fluid_.size());
  const FlowView flow = view();
  over_awake(FindShift{flow, dt});
  on_.for_each(fluid_.size(), PackShift{flow, motion_.data()});
  sweep_over(awake_, ShiftSweep{pair_sums(), motion_.data(), {flow, dt}});
  over_awake(MoveByShift{flow});
}

template <class Executor>
void DeviceBackend<Executor>::advance_state() {
  const double dt = chosen_step().dt;
  if (model_.particle_shifting > 0) shift_particles(dt);
  const Clock clock(*this, "density and viscosity");
  const AdvanceState advance{view(), awake_.data(), dt, AdvanceState::caught_up(model_, dt)};
  enter<StepHeat>(awake_.size(), advance);
  over_driven(MoveDriven{view(), dt});
  std::visit(
      [&](const auto& law) {
        over_awake(FindViscosity<std::decay_t<decltype(law)>>{view(), law});
      },
      model_.rheology);
  fluid_changed();
}

template <class Executor>
void DeviceBackend<Executor>::update_sleep() {
  if (!(model_.sleep.speed > 0)) return;
  const Clock clock(*this, "sleep");
  Array<char> wakes;
  on_.reserve(wakes, fluid_.size());
  const FlowView flow = view();
  on_.for_each(fluid_.size(), FindWoken<RowNear>{flow, RowNear{rows()}, wakes.data()});
  on_.for_each(fluid_.size(), WakeAndHold{flow, wakes.data()});
  const auto woken = on_.template reduce<Total>(fluid_.size(), CountWoken{wakes.data()});
  const std::size_t before = awake_.size();
  list_awake();
  if (woken.value > 0 || awake_.size() != before) prepare_rows();
  fluid_changed();
}

template <class Executor>
void DeviceBackend<Executor>::set_sound_speed(double c0) {
  const Clock clock(*this, "checks and sums");
  const Tait former = model_.state;
  model_.state.c0 = c0;
  const ChangeSoundSpeed change{former, model_.state, fluid_.view(), !model_.tension_at_surface};
  enter<SoundHeat>(fluid_.size(), change);
  scale_.set_sound_speed(model_);
  fluid_changed();
}

}  // namespace sabo
