#include <cmath>
#include <utility>
#include <variant>

#include "backend/compact.hpp"
#include "backend/host_backend.hpp"
#include "backend/host_near.hpp"
#include "backend/sweeps/boundary_sweeps.hpp"
#include "backend/sweeps/driven.hpp"
#include "backend/sweeps/implicit_sweeps.hpp"
#include "backend/sweeps/shifting.hpp"
#include "backend/sweeps/sleep.hpp"

// The sweeps of the implicit method that look at one particle at a time, and those over the fluid
// near a particle that are the same for every host backend.

namespace sabo {

void HostBackend::wall_resistance() {
  const PassClock clock(pass_times_, "wall law");
  const auto with = [&](const auto& law, const auto& wall_law) {
    using Find = FindWallResistance<std::decay_t<decltype(law)>, std::decay_t<decltype(wall_law)>>;
    over_rows(awake_, threads(), Find{view(), law, wall_law});
  };
  std::visit(with, model_.rheology, model_.wall);
}

void HostBackend::find_diffusion_background() {
  if (model_.diffusion_form == DiffusionForm::fourtakas)
    over_rows(awake_, threads(), FindDiffusionBackground{view()});
}

void HostBackend::advance_state() {
  const double dt = step_.dt;
  if (model_.particle_shifting > 0) shift_particles(dt);
  const PassClock clock(pass_times_, "density and viscosity");
  const AdvanceState advance{view(), awake_.data(), dt, AdvanceState::caught_up(model_, dt)};
  on_.sum_up<StepHeat>(awake_.size(), advance, EnterHeat{&heat_});
  over_rows(driven_, threads(), MoveDriven{view(), dt});
  find_viscosity();
}

void HostBackend::find_viscosity() {
  std::visit(
      [&](const auto& law) {
        over_rows(awake_, threads(), FindViscosity<std::decay_t<decltype(law)>>{view(), law});
      },
      model_.rheology);
}

/// Before the flow moves them: all sums of the step are of the places that particles have now.
void HostBackend::shift_particles(double dt) {
  const PassClock clock(pass_times_, "shifting");
  shift_.assign(fluid_.size(), {});
  if (!(dt > 0)) return;
  const FlowView flow = view();
  over_rows(awake_, threads(), FindShift{flow, dt});
  fill_by_shifts(dt);
  over_rows(awake_, threads(), MoveByShift{flow});
}

void HostBackend::list_awake() {
  awake_.clear();
  driven_.clear();
  for (std::size_t i = 0; i < fluid_.size(); ++i) {
    if (fluid_.driven[i] != 0)
      driven_.push_back(static_cast<std::uint32_t>(i));
    else if (!is_asleep(i))
      awake_.push_back(static_cast<std::uint32_t>(i));
  }
  asleep_count_ = fluid_.size() - awake_.size() - driven_.size();
}

bool HostBackend::is_asleep(std::size_t i) const { return sabo::is_asleep(model_, fluid_.calm[i]); }

void HostBackend::update_sleep() {
  if (!(model_.sleep.speed > 0)) return;
  const PassClock clock(pass_times_, "sleep");
  std::vector<char> wakes(fluid_.size(), 0);
  const FlowView flow = view();
  on_.for_each_slow(fluid_.size(), FindWoken<HostNear>{flow, HostNear(*this), wakes.data()});
  const std::size_t before = awake_.size();
  const bool changes = std::ranges::count(wakes, 1) > 0;
  on_.for_each(fluid_.size(), WakeAndHold{flow, wakes.data()});
  list_awake();
  if (changes || awake_.size() != before) prepare_rows();
}

void HostBackend::list_bodies() {
  list_kept(on_, boundary_.size(), BelongsToBody{view_of(boundary_)}, body_rows_);
  std::vector<BodyForce> particles(body_rows_.size());
  on_.for_each(particles.size(),
               FindBodyParticle{view_of(boundary_), body_rows_.data(), particles.data()});
  body_loads_.list(std::move(particles), ground_level_);
  row_forces_.assign(body_rows_.size(), {});
}

/// Adds force(i, b, pair) on boundary particle b by each fluid particle i near it, N.
template <class PairForce>
void HostBackend::add_to_bodies(const PairForce& force) {
  const PassClock clock(pass_times_, "bodies");
  using Add = AddToBody<HostNear, PairForce>;
  const Add add{view(), HostNear(*this), body_rows_.data(), force, row_forces_.data()};
  on_.for_each_slow(body_rows_.size(), add);
  body_loads_.sum(row_forces_);
}

void HostBackend::load_bodies_by_stress() {
  if (body_loads_.loads().empty()) return;
  row_forces_.assign(body_rows_.size(), {});
  add_to_bodies(StressOnBody{view()});
}

void HostBackend::load_bodies_by_pressure() {
  if (body_loads_.loads().empty()) return;
  row_forces_.assign(body_rows_.size(), {});
  add_to_bodies(PressureOnBody{view()});
}

void HostBackend::load_bodies_by_friction() {
  if (!body_loads_.loads().empty()) add_to_bodies(FrictionOnBody{view()});
}

}  // namespace sabo
