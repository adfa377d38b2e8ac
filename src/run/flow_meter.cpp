#include "run/flow_meter.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/error.hpp"
#include "run/rest_text.hpp"

namespace sabo {
namespace {

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

}  // namespace

FlowMeter::FlowMeter(const Case& c, const Scene& scene, const FlowModel& model,
                     const RunFolder& folder)
    : model_(model),
      columns_(scene.surface->elevation(), c.numerics.spacing, c.material.density),
      section_states_(scene, model, folder),
      gauges_(scene, model, folder),
      fillings_(scene, folder),
      loads_(c.loads, scene, model, folder),
      front_(scene.path),
      rest_(rest_limits(c.run), c.numerics.spacing, c.material.density, last_start(scene)),
      maps_(scene.surface->elevation(), c.numerics.spacing, c.material.density),
      has_places_(!scene.zones.empty() || !scene.gauges.empty() || !loads_.is_empty()),
      tables_(scene, folder) {
  for (const NamedZone& zone : scene.zones)
    zones_.emplace_back(scene.surface->elevation(), zone.polygons);
}

Energy FlowMeter::energy_in(const Particles& fluid, const Tait& state) const {
  return energy_of(fluid, model_.gravity, state, !model_.tension_at_surface);
}

SeriesRow FlowMeter::write_row(const RowStart& start, const Particles& fluid) {
  SeriesRow row = start.row;
  row.front = front_.update(row.time, fluid);
  row.energy = energy_in(fluid, start.state);
  row.entered += energy_in(driven_part(fluid), start.state);
  row.entered.elastic += start.pushed;
  if (!first_energy_)
    first_energy_ = row.energy;
  else if (row.inflows.empty())
    check_energy(row);
  rest_.update(row.time, fluid);
  row.motion = rest_.state();

  if (has_places_) columns_.update(fluid);
  for (const Zone& zone : zones_)
    row.zones.push_back(zone.measure([this](std::size_t cell) { return columns_.depth(cell); },
                                     columns_.threshold()));
  section_states_.write_row(row.time, fluid);
  gauges_.write_row(row.time, fluid, columns_);
  row.basins = fillings_.write_row(row.time, columns_);
  row.loads = loads_.write_row(row.time, start.loads, columns_);
  tables_.append(row);
  return row;
}

/// No result is worth having of a flow with more energy than it can have; compression and rounding
/// are far below what a fall by a spacing gives. Inflows push, and what they give is not all known.
void FlowMeter::check_energy(const SeriesRow& row) const {
  const double gravity = norm(model_.gravity);
  const double surplus = surplus_fall(*first_energy_, row.energy, row.left, gravity);
  if (surplus <= model_.spacing) return;
  throw RunError(
      fmt::format("the flow has gained energy at t = {:g} s: as much as if all of it had fallen "
                  "{:.3g} m more than it has; lower numerics.cfl, or raise "
                  "numerics.reference_speed to the fastest speed expected",
                  row.time, surplus));
}

}  // namespace sabo
