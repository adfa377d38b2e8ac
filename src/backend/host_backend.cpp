#include "backend/host_backend.hpp"

#include <variant>

#include "backend/compact.hpp"
#include "backend/host_near.hpp"
#include "backend/sweeps/boundary_sweeps.hpp"
#include "backend/sweeps/driven.hpp"
#include "backend/sweeps/explicit_sweeps.hpp"
#include "backend/sweeps/flow_sums.hpp"

namespace sabo {

HostBackend::HostBackend(const FlowModel& model)
    : Backend(model),
      half_space_(model.h, model.dimension, model.spacing),
      yield_slope_(model.yield.slope()),
      on_(host_threads(model.threads)) {}

FlowView HostBackend::view() {
  FlowView flow;
  flow.model = model_;
  flow.yield_slope = yield_slope_;
  flow.half_space = &half_space_;
  flow.fluid_count = fluid_.size();
  flow.fluid = view_of(fluid_);
  flow.boundary = view_of(boundary_);
  FlowArrays::point(flow, *this);
  return flow;
}

void HostBackend::find_neighbours() {
  if (model_.periodic.any())
    on_.for_each(fluid_.size(), WrapPosition{model_.periodic, fluid_.position.data()});
  list_pairs();
  list_bodies();
  settle_driven();
  const std::size_t all = fluid_.size() + boundary_.size();
  strain_.assign(all, {});
  stress_.assign(all, {});
  density_rate_.assign(all, 0);
  driven_walls_.clear();
  if (!driven_.empty()) {
    const MayTouchDriven<HostNear> may_touch{view(), HostNear(*this)};
    list_kept(on_, boundary_.size(), may_touch, driven_walls_);
  }
  hold_walls();
  acceleration_.assign(fluid_.size(), {});
  pressure_power_.assign(fluid_.size(), 0);
  wall_share_.assign(fluid_.size(), {});
  wall_drag_.assign(fluid_.size(), 0);
  wall_grip_.assign(fluid_.size(), {});
  support_.assign(fluid_.size(), 0);
  filling_.assign(fluid_.size(), {});
  background_.assign(fluid_.size(), {});
  shift_.assign(fluid_.size(), {});
  for (std::vector<double>* of_fluid : {&artificial_heat_, &diffusion_rate_, &wall_heat_})
    of_fluid->assign(fluid_.size(), 0);
}

void HostBackend::pressure() {
  const PassClock clock(pass_times_, "pressure");
  for (Particles* particles : {&fluid_, &boundary_})
    on_.for_each(particles->size(), FindPressure{model_.state, view_of(*particles)});
}

void HostBackend::stress() {
  const PassClock clock(pass_times_, "stress");
  find_stress(on_, view(), boundary_.size());
}

void HostBackend::extrapolate_to_boundary() {
  const PassClock clock(pass_times_, "start of the boundary");
  on_.for_each_slow(boundary_.size(), ExtrapolateToBoundary<HostNear>{view(), HostNear(*this)});
}

void HostBackend::add_central_force() {
  if (model_.central.strength == 0) return;
  over_rows(awake_, threads(), [&](std::size_t i) {
    acceleration_[i] -= model_.central.strength * (fluid_.position[i] - model_.central.origin);
  });
}

void HostBackend::settle_driven() {
  const auto settle = [&](const auto& law) {
    over_rows(driven_, threads(), SettleDriven<std::decay_t<decltype(law)>>{view(), law});
  };
  std::visit(settle, model_.rheology);
}

void HostBackend::hold_driven() {
  over_rows(driven_, threads(), HoldDriven{view()});
  hold_walls();
}

void HostBackend::hold_walls() {
  using Hold = HoldWall<HostNear>;
  on_.for_each_slow(driven_walls_.size(),
                    AtRow<Hold>{driven_walls_.data(), {view(), HostNear(*this)}});
}

Fastest HostBackend::find_fastest() const {
  const PassClock clock(pass_times_, "checks and sums");
  const FindFastest find{{awake_.data(), awake_.size()}, {driven_.data(), driven_.size()},
                         has_neighbours_.data(),         fluid_.velocity.data(),
                         acceleration_.data(),           fluid_.viscosity.data(),
                         fluid_.density.data()};
  return on_.reduce<Fastest>(awake_.size() + driven_.size(), find);
}

double HostBackend::fastest() const { return std::sqrt(find_fastest().speed2); }

void HostBackend::choose_step(const StepRule& rule, double longest) {
  const Fastest fastest = find_fastest();
  std::visit(
      [&](const auto& by) {
        ChooseStep<std::decay_t<decltype(by)>>{by, longest, &step_}(fastest);
      },
      rule);
}

FlowHealth HostBackend::health() const {
  const PassClock clock(pass_times_, "checks and sums");
  const FindCondition find{fluid_.position.data(), fluid_.velocity.data(), fluid_.density.data(),
                           model_.state.rho0};
  const auto condition = on_.reduce<Condition>(fluid_.size(), find);
  return {condition.lowest, condition.highest, condition.broken == 0};
}

void HostBackend::predict() {
  const PassClock clock(pass_times_, "integration");
  start_position_ = fluid_.position;
  start_velocity_ = fluid_.velocity;
  start_density_ = fluid_.density;
  start_boundary_density_ = boundary_.density;
  on_.for_each(fluid_.size(), PredictFluid{view(), &step_});
  on_.for_each(boundary_.size(), PredictBoundary{view(), &step_});
}

void HostBackend::correct() {
  const PassClock clock(pass_times_, "integration");
  on_.sum_up<ExplicitHeat>(fluid_.size(), FindExplicitHeat{view(), &step_}, EnterHeat{&heat_});
  const StepStart start{start_position_.data(), start_velocity_.data(), start_density_.data(),
                        start_boundary_density_.data()};
  on_.for_each(fluid_.size(), CorrectFluid{view(), start, &step_});
  on_.for_each(boundary_.size(), CorrectBoundary{view(), start, &step_});
}

void HostBackend::set_sound_speed(double c0) {
  const Tait former = model_.state;
  model_.state.c0 = c0;
  const ChangeSoundSpeed change{former, model_.state, view_of(fluid_), !model_.tension_at_surface};
  on_.sum_up<SoundHeat>(fluid_.size(), change, EnterHeat{&heat_});
}

}  // namespace sabo
