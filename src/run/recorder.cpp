#include "run/recorder.hpp"

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "run/show_fluid.hpp"

namespace sabo {
namespace {

std::vector<VolumeLedger> make_ledgers(const Case& c, const Scene& scene) {
  std::vector<VolumeLedger> ledgers;
  for (const CheckDam& dam : scene.check_dams())
    ledgers.emplace_back(c.material.density, dam.axis, scene.release_centre);
  if (ledgers.empty()) ledgers.emplace_back(c.material.density);
  for (VolumeLedger& ledger : ledgers) ledger.release(scene.release);
  return ledgers;
}

SolverRow solver_row(const Stepper& stepper, const StepReport& report, const FlowHealth& health,
                     const Backend& backend) {
  return {static_cast<double>(stepper.steps()),
          report.dt,
          report.flow.speed,
          health.min_density_ratio,
          health.max_density_ratio,
          static_cast<double>(backend.fluid_count()),
          static_cast<double>(backend.boundary_count()),
          static_cast<double>(backend.asleep_count()),
          report.sound_speed,
          static_cast<double>(report.iterations)};
}

}  // namespace

Recorder::Recorder(const Case& c, const Scene& scene, const FlowModel& model,
                   const RunFolder& folder)
    : method_(c.numerics.method),
      may_stop_at_rest_(c.run.stop_at_rest),
      threads_(model.threads),
      density_(model.state.rho0),
      ledgers_(make_ledgers(c, scene)),
      load_account_(c.loads, scene, model),
      sampling_distance_(std::max({scene.surface->elevation().grid.dx,
                                   scene.surface->elevation().grid.dy, c.numerics.spacing})),
      look_distance_(0.5 * c.numerics.spacing),
      meter_(c, scene, model, folder) {
  for (const NamedSection& section : scene.sections) sections_.emplace_back(section.line);
  for (const InflowPlan& inflow : scene.inflows) inflow_plans_.push_back(&inflow);
  inflows_.resize(inflow_plans_.size());
  tracks_.advance(scene.release);
}

void Recorder::start(double time, const Particles& fluid, const Particles& release) {
  std::vector<char> is_there(release.size(), 0);
  for (const std::uint32_t id : fluid.id)
    if (id < is_there.size()) is_there[id] = 1;
  std::vector<std::uint32_t> gone_rows;
  for (std::uint32_t i = 0; i < release.size(); ++i)
    if (!is_there[release.id[i]]) gone_rows.push_back(i);
  Particles gone;
  gone.append(release, gone_rows);
  const std::vector<Vec3d>& before = tracks_.advance(fluid);
  for (VolumeLedger& ledger : ledgers_) {
    ledger.record(before, fluid);
    ledger.leave(gone);
  }
  load_account_.start(time);
  meter_.maps().update(time, fluid);
  meter_.rest().update(time, fluid);
  take_rest_due(time);
  motion_ = meter_.rest().state();
}

void Recorder::follow(const Particles& fluid) {
  for (const VolumeLedger& ledger : ledgers_)
    if (!ledger.knows(fluid)) throw RunError("holds particles that were never released");
  if (unseen_ > 0) return;
  tracks_ = {};
  tracks_.advance(fluid);
}

void Recorder::after_entry(Domain& domain, const Tait& state) {
  const Particles entered = domain.take_entered();
  const Particles freed = domain.take_freed();
  freed_ += meter_.energy_in(freed, state);
  pushed_ += push_behind(freed, state);
  for (std::size_t k = 0; k < inflows_.size(); ++k)
    inflows_[k].entered = domain.inflows()[k].entered();
  if (entered.size() == 0) return;
  for (VolumeLedger& ledger : ledgers_) ledger.release(entered);
}

void Recorder::after_step(const Stepper& stepper, const StepReport& report, Backend& backend) {
  const double time = stepper.time();
  load_account_.after_step(stepper, report, backend);
  const double way = report.flow.speed * report.dt;
  travelled_ += way;
  unseen_ += way;
  const bool is_copied = backend.device_bytes() > 0;
  if (is_copied && unseen_ < look_distance_ && travelled_ < sampling_distance_ && time < rest_due_)
    return;
  look(time, backend);
}

/// Where the particles are now, and which lines they have crossed on the straight way from where
/// they were at the last look. One that costs a copy is not taken at every step.
void Recorder::look(double time, Backend& backend) {
  const Places now = backend.places();
  const std::vector<Vec3d>& before = tracks_.advance(now, threads_);
  unseen_ = 0;
  for (Section& section : sections_) section.record(before, now, density_, threads_);
  for (VolumeLedger& ledger : ledgers_) ledger.record(before, now, threads_);
  const bool is_for_rest = take_rest_due(time), is_for_maps = travelled_ >= sampling_distance_;
  if (!is_for_rest && !is_for_maps) return;
  if (is_for_maps) travelled_ = 0;
  show(time, backend, [this, time, is_for_rest, is_for_maps](const Particles& fluid) {
    if (is_for_rest) meter_.rest().update(time, fluid);
    if (is_for_maps) meter_.maps().update(time, fluid);
  });
}

/// Whether the watch for rest has to see the particles, which it does then.
bool Recorder::take_rest_due(double time) {
  if (time < rest_due_) return false;
  rest_due_ = time + meter_.rest().interval();
  return true;
}

/// Lets the meter see the fluid. A run that could end with what it sees waits.
void Recorder::show(double time, Backend& backend,
                    const std::function<void(const Particles&)>& measure) {
  settle();
  const bool may_end = may_stop_at_rest_ && meter_.rest().may_find_rest(time);
  show_fluid(backend, measuring_, measure);
  if (may_end || backend.device_bytes() == 0) settle();
}

void Recorder::settle() {
  measuring_.settle();
  if (written_) rows_.push_back(*std::exchange(written_, std::nullopt));
  motion_ = meter_.rest().state();
}

void Recorder::finish(double time, const Particles& fluid) {
  settle();
  meter_.maps().update(time, fluid);
}

void Recorder::after_renewal(Domain& domain, const Tait& state) {
  const Particles departed = domain.take_departed();
  const std::size_t put_back = domain.put_back_count() - put_back_seen_;
  put_back_seen_ += put_back;
  left_ += meter_.energy_in(departed, state);
  for (VolumeLedger& ledger : ledgers_) {
    if (departed.size() > 0) ledger.leave(departed);
    ledger.put_back(put_back);
  }
}

void Recorder::write_row(const Stepper& stepper, const StepReport& report, const FlowHealth& health,
                         Backend& backend) {
  const double time = stepper.time();
  if (unseen_ > 0) look(time, backend);
  settle();             // the row before says when this one's means begin
  take_rest_due(time);  // every row looks for it
  show(time, backend,
       [this, start = start_of_row(stepper, report, health, backend)](const Particles& fluid) {
         written_ = meter_.write_row(start, fluid);
       });
}

RowStart Recorder::start_of_row(const Stepper& stepper, const StepReport& report,
                                const FlowHealth& health, Backend& backend) {
  RowStart start{{}, pushed_, backend.model().state, load_account_.take_means(stepper, backend)};
  SeriesRow& row = start.row;
  row.time = stepper.time();
  row.entered = freed_;
  row.left = left_;
  row.dissipated = stepper.dissipated();
  row.numerical = backend.heat().numerical;
  // What driven particles do to the flow counts there as given by walls.
  if (method_ == Method::fast) row.numerical.walls += pushed_;

  const double interval = rows_.empty() ? 0 : row.time - rows_.back().time;
  for (Section& section : sections_) {
    const double volume = section.take_interval().net();
    row.discharge.push_back(interval > 0 ? volume / interval : 0);
    row.passed.push_back(section.total());
  }
  for (const VolumeLedger& ledger : ledgers_) row.volumes.push_back(ledger.row());
  for (std::size_t k = 0; k < inflows_.size(); ++k)
    inflows_[k].hydrograph = inflow_plans_[k]->hydrograph.volume_until(row.time);
  row.inflows = inflows_;
  row.solver = solver_row(stepper, report, health, backend);
  return start;
}

}  // namespace sabo
