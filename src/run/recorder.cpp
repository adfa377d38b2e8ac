#include "run/recorder.hpp"

#include <algorithm>
#include <functional>
#include <string>

#include <fmt/format.h>

#include "base/error.hpp"
#include "run/rest_text.hpp"

namespace sabo {
namespace {

std::vector<std::string> discharge_header(const Scene& scene) {
  std::vector<std::string> header{"time [s]"};
  for (const NamedSection& section : scene.sections) {
    header.push_back(section.name + " net discharge [m3/s]");
    header.push_back(section.name + " forward volume [m3]");
    header.push_back(section.name + " backward volume [m3]");
  }
  return header;
}

std::vector<std::string> volumes_header(const Scene& scene) {
  std::vector<std::string> header{"time [s]", "released [m3]", "outflow [m3]", "put back [count]"};
  for (const CheckDam& dam : scene.check_dams()) {
    header.push_back(dam.name + " trapped [m3]");
    header.push_back(dam.name + " beyond [m3]");
  }
  for (const InflowPlan& inflow : scene.inflows) {
    header.push_back(inflow.name + " entered [m3]");
    header.push_back(inflow.name + " hydrograph [m3]");
  }
  return header;
}

std::vector<std::string> zones_header(const Scene& scene) {
  std::vector<std::string> header{"time [s]"};
  for (const NamedZone& zone : scene.zones) {
    header.push_back(zone.name + " mean depth where wet [m]");
    header.push_back(zone.name + " mean depth [m]");
    header.push_back(zone.name + " greatest depth [m]");
    header.push_back(zone.name + " volume [m3]");
  }
  return header;
}

std::vector<std::string> energy_header(const Scene& scene) {
  std::vector<std::string> header{"time [s]",      "mass [kg]",       "kinetic [J]",
                                  "potential [J]", "elastic [J]",     "dissipated [J]",
                                  "numerical [J]", "left the map [J]"};
  if (!scene.inflows.empty()) header.push_back("brought by inflows [J]");
  return header;
}

/// When the last of the mass starts to move, s.
double last_start(const Scene& scene) {
  double last = 0;
  for (const InflowPlan& inflow : scene.inflows) last = std::max(last, inflow.hydrograph.end());
  return last;
}

/// Particles that inflows move.
Particles driven_part(const Particles& fluid) {
  std::vector<std::uint32_t> rows;
  for (std::uint32_t i = 0; i < fluid.size(); ++i)
    if (fluid.driven[i] != 0) rows.push_back(i);
  Particles driven;
  driven.append(fluid, rows);
  return driven;
}

std::vector<VolumeLedger> make_ledgers(const Case& c, const Scene& scene) {
  std::vector<VolumeLedger> ledgers;
  for (const CheckDam& dam : scene.check_dams())
    ledgers.emplace_back(c.material.density, dam.axis, scene.release_centre);
  if (ledgers.empty()) ledgers.emplace_back(c.material.density);
  for (VolumeLedger& ledger : ledgers) ledger.release(scene.release);
  return ledgers;
}

}  // namespace

Recorder::Recorder(const Case& c, const Scene& scene, const FlowModel& model,
                   const RunFolder& folder)
    : model_(model),
      method_(c.numerics.method),
      columns_(scene.surface->elevation(), c.numerics.spacing, c.material.density),
      ledgers_(make_ledgers(c, scene)),
      section_states_(scene, model, folder),
      gauges_(scene, model, folder),
      fillings_(scene, folder),
      loads_(c.loads, scene, model, folder),
      front_(scene.path),
      rest_(rest_limits(c.run), c.numerics.spacing, c.material.density, last_start(scene)),
      maps_(scene.surface->elevation(), c.numerics.spacing, c.material.density),
      sampling_distance_(std::max({scene.surface->elevation().grid.dx,
                                   scene.surface->elevation().grid.dy, c.numerics.spacing})),
      look_distance_(0.5 * c.numerics.spacing),
      has_dams_(!scene.check_dams().empty()),
      has_places_(!scene.zones.empty() || !scene.gauges.empty() || !loads_.is_empty()),
      front_csv_(folder.series_file("front.csv"),
                 {"time [s]", "position [m]", "displacement [m]", "velocity [m/s]"}),
      discharge_csv_(folder.series_file("discharge.csv"), discharge_header(scene)),
      volumes_csv_(folder.series_file("volumes.csv"), volumes_header(scene)),
      zones_csv_(folder.series_file("zones.csv"), zones_header(scene)),
      energy_csv_(folder.series_file("energy.csv"), energy_header(scene)),
      rest_csv_(folder.series_file("rest.csv"),
                {"time [s]", "moving volume [m3]", "kinetic energy over its peak",
                 "creep [spacings/min]"}),
      solver_csv_(
          folder.series_file("solver.csv"),
          {"time [s]", "step [count]", "time step [s]", "fastest [m/s]", "lowest density ratio",
           "highest density ratio", "fluid [count]", "boundary [count]", "sound speed [m/s]",
           "viscous iterations [count]", "asleep [count]"}) {
  for (const NamedSection& section : scene.sections) sections_.emplace_back(section.line);
  for (const InflowPlan& inflow : scene.inflows) inflow_plans_.push_back(&inflow);
  inflows_.resize(inflow_plans_.size());
  for (const NamedZone& zone : scene.zones)
    zones_.emplace_back(scene.surface->elevation(), zone.polygons);
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
  maps_.update(time, fluid);
  rest_.update(time, fluid);
}

void Recorder::follow(const Particles& fluid) {
  for (const VolumeLedger& ledger : ledgers_)
    if (!ledger.knows(fluid)) throw RunError("holds particles that were never released");
  if (unseen_ > 0) return;
  tracks_ = {};
  tracks_.advance(fluid);
}

Energy Recorder::energy_in(const Particles& fluid, const Tait& state) const {
  return energy_of(fluid, model_.gravity, state, !model_.tension_at_surface);
}

void Recorder::after_entry(Domain& domain, const Tait& state) {
  const Particles entered = domain.take_entered();
  const Particles freed = domain.take_freed();
  freed_ += energy_in(freed, state);
  pushed_ += push_behind(freed, state);
  for (std::size_t k = 0; k < inflows_.size(); ++k)
    inflows_[k].entered = domain.inflows()[k].entered();
  if (entered.size() == 0) return;
  for (VolumeLedger& ledger : ledgers_) ledger.release(entered);
}

void Recorder::after_step(const Stepper& stepper, const StepReport& report, Backend& backend) {
  const double time = stepper.time();
  loads_.after_step(stepper, report, backend);
  const double way = report.flow.speed * report.dt;
  travelled_ += way;
  unseen_ += way;
  const bool is_copied = backend.device_bytes() > 0;
  if (is_copied && unseen_ < look_distance_ && travelled_ < sampling_distance_ &&
      !rest_.is_due(time))
    return;
  look(time, backend);
}

/// Where the particles are now, and which lines they have crossed on the straight way from where
/// they were at the last look. One that costs a copy is not taken at every step.
void Recorder::look(double time, Backend& backend) {
  const Places now = backend.places();
  const std::vector<Vec3d>& before = tracks_.advance(now, model_.threads);
  unseen_ = 0;
  for (Section& section : sections_) section.record(before, now, model_.state.rho0, model_.threads);
  for (VolumeLedger& ledger : ledgers_) ledger.record(before, now, model_.threads);
  if (rest_.is_due(time)) rest_.update(time, backend.fluid());
  if (travelled_ < sampling_distance_) return;
  sample_maps(time, backend);
  travelled_ = 0;
}

/// Beside the steps, where these leave the host to itself.
void Recorder::sample_maps(double time, Backend& backend) {
  if (backend.device_bytes() == 0) return maps_.update(time, backend.fluid());
  mapping_.settle();
  const std::function<void()> fill_seen = backend.copy_fluid(seen_);
  mapping_.start([this, time, fill_seen] {
    fill_seen();
    maps_.update(time, seen_);
  });
}

void Recorder::finish(double time, const Particles& fluid) {
  mapping_.settle();
  maps_.update(time, fluid);
}

const FlowMaps& Recorder::maps() {
  mapping_.settle();
  return maps_;
}

void Recorder::after_renewal(Domain& domain, const Tait& state) {
  const Particles departed = domain.take_departed();
  const std::size_t put_back = domain.put_back_count() - put_back_seen_;
  put_back_seen_ += put_back;
  left_ += energy_in(departed, state);
  for (VolumeLedger& ledger : ledgers_) {
    if (departed.size() > 0) ledger.leave(departed);
    ledger.put_back(put_back);
  }
}

void Recorder::write_row(const Stepper& stepper, const StepReport& report, const FlowHealth& health,
                         Backend& backend) {
  if (unseen_ > 0) look(stepper.time(), backend);
  SeriesRow row;
  row.time = stepper.time();
  const double interval = rows_.empty() ? 0 : row.time - rows_.back().time;
  row.front = front_.update(row.time, backend.fluid());
  const Tait& state = backend.model().state;
  row.energy = energy_in(backend.fluid(), state);
  row.entered = freed_ + energy_in(driven_part(backend.fluid()), state);
  row.entered.elastic += pushed_;
  row.left = left_;
  row.dissipated = stepper.dissipated();
  row.numerical = backend.heat().numerical;
  // What driven particles do to the flow counts there as given by walls.
  if (method_ == Method::fast) row.numerical.walls += pushed_;
  if (!rows_.empty() && inflows_.empty()) check_energy(row);
  rest_.update(row.time, backend.fluid());
  row.motion = rest_.state();

  std::vector<double> discharge{row.time};
  for (Section& section : sections_) {
    const double volume = section.take_interval().net();
    row.discharge.push_back(interval > 0 ? volume / interval : 0);
    discharge.insert(discharge.end(),
                     {row.discharge.back(), section.total().forward, section.total().backward});
  }
  for (const VolumeLedger& ledger : ledgers_) row.volumes.push_back(ledger.row());
  const VolumeRow& first = row.volumes.front();
  std::vector<double> volumes{row.time, first.released, first.outflow,
                              static_cast<double>(first.put_back)};
  if (has_dams_)
    for (const VolumeRow& at_dam : row.volumes)
      volumes.insert(volumes.end(), {at_dam.trapped, at_dam.beyond});

  for (std::size_t k = 0; k < inflows_.size(); ++k) {
    inflows_[k].hydrograph = inflow_plans_[k]->hydrograph.volume_until(row.time);
    volumes.insert(volumes.end(), {inflows_[k].entered, inflows_[k].hydrograph});
  }
  row.inflows = inflows_;

  front_csv_.append({row.time, row.front.position, row.front.displacement, row.front.velocity});
  discharge_csv_.append(discharge);
  if (has_places_) columns_.update(backend.fluid());
  write_zones(row);
  section_states_.write_row(row.time, backend.fluid());
  gauges_.write_row(row.time, backend.fluid(), columns_);
  row.basins = fillings_.write_row(row.time, columns_);
  row.loads = loads_.write_row(row.time, stepper, backend, columns_);
  volumes_csv_.append(volumes);
  std::vector<double> energies{
      row.time,           row.energy.mass, row.energy.kinetic,    row.energy.potential,
      row.energy.elastic, row.dissipated,  row.numerical.total(), row.left.total()};
  if (!inflows_.empty()) energies.push_back(row.entered.total());
  energy_csv_.append(energies);
  rest_csv_.append({row.time, row.motion.moving_volume, row.motion.energy_share, row.motion.creep});
  write_solver_row(stepper, report, health, backend);
  rows_.push_back(std::move(row));
}

/// No result is worth having of a flow with more energy than it can have; compression and rounding
/// are far below what a fall by a spacing gives. Inflows push, and what they give is not all known.
void Recorder::check_energy(const SeriesRow& row) const {
  const double gravity = norm(model_.gravity);
  const double surplus = surplus_fall(rows_.front().energy, row.energy, row.left, gravity);
  if (surplus <= model_.spacing) return;
  throw RunError(
      fmt::format("the flow has gained energy at t = {:g} s: as much as if all of it had fallen "
                  "{:.3g} m more than it has; lower numerics.cfl, or raise "
                  "numerics.reference_speed to the fastest speed expected",
                  row.time, surplus));
}

void Recorder::write_zones(SeriesRow& row) {
  std::vector<double> values{row.time};
  for (const Zone& zone : zones_) {
    const ZoneDepth depth = zone.measure([this](std::size_t cell) { return columns_.depth(cell); },
                                         columns_.threshold());
    values.insert(values.end(), {depth.mean_wet, depth.mean_all, depth.greatest, depth.volume});
    row.zones.push_back(depth);
  }
  zones_csv_.append(values);
}

void Recorder::write_solver_row(const Stepper& stepper, const StepReport& report,
                                const FlowHealth& health, const Backend& backend) {
  solver_csv_.append({stepper.time(), static_cast<double>(stepper.steps()), report.dt,
                      report.flow.speed, health.min_density_ratio, health.max_density_ratio,
                      static_cast<double>(backend.fluid_count()),
                      static_cast<double>(backend.boundary_count()), report.sound_speed,
                      static_cast<double>(report.iterations),
                      static_cast<double>(backend.asleep_count())});
}

}  // namespace sabo
