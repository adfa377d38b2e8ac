#include "run/series_tables.hpp"

#include <string>
#include <vector>

#include "run/series_header.hpp"

namespace sabo {
namespace {

std::vector<std::string> discharge_header(const Scene& scene) {
  std::vector<std::string> header{"time [s]"};
  for (const NamedSection& section : scene.sections)
    add_columns(header, section.name,
                {"net discharge [m3/s]", "forward volume [m3]", "backward volume [m3]"});
  return header;
}

std::vector<double> discharges(const SeriesRow& row) {
  std::vector<double> values{row.time};
  for (std::size_t k = 0; k < row.passed.size(); ++k)
    values.insert(values.end(), {row.discharge[k], row.passed[k].forward, row.passed[k].backward});
  return values;
}

std::vector<std::string> volumes_header(const Scene& scene) {
  std::vector<std::string> header{"time [s]", "released [m3]", "outflow [m3]", "put back [count]"};
  for (const CheckDam& dam : scene.check_dams())
    add_columns(header, dam.name, {"trapped [m3]", "beyond [m3]"});
  for (const InflowPlan& inflow : scene.inflows)
    add_columns(header, inflow.name, {"entered [m3]", "hydrograph [m3]"});
  return header;
}

std::vector<double> volumes(const SeriesRow& row, bool has_dams) {
  const VolumeRow& first = row.volumes.front();
  std::vector<double> values{row.time, first.released, first.outflow,
                             static_cast<double>(first.put_back)};
  if (has_dams)
    for (const VolumeRow& at_dam : row.volumes)
      values.insert(values.end(), {at_dam.trapped, at_dam.beyond});
  for (const InflowRow& inflow : row.inflows)
    values.insert(values.end(), {inflow.entered, inflow.hydrograph});
  return values;
}

std::vector<std::string> zones_header(const Scene& scene) {
  std::vector<std::string> header{"time [s]"};
  for (const NamedZone& zone : scene.zones)
    add_columns(
        header, zone.name,
        {"mean depth where wet [m]", "mean depth [m]", "greatest depth [m]", "volume [m3]"});
  return header;
}

std::vector<double> depths(const SeriesRow& row) {
  std::vector<double> values{row.time};
  for (const ZoneDepth& depth : row.zones)
    values.insert(values.end(), {depth.mean_wet, depth.mean_all, depth.greatest, depth.volume});
  return values;
}

std::vector<std::string> energy_header(const Scene& scene) {
  std::vector<std::string> header{"time [s]",      "mass [kg]",       "kinetic [J]",
                                  "potential [J]", "elastic [J]",     "dissipated [J]",
                                  "numerical [J]", "left the map [J]"};
  if (!scene.inflows.empty()) header.push_back("brought by inflows [J]");
  return header;
}

std::vector<double> energies(const SeriesRow& row) {
  std::vector<double> values{
      row.time,           row.energy.mass, row.energy.kinetic,    row.energy.potential,
      row.energy.elastic, row.dissipated,  row.numerical.total(), row.left.total()};
  if (!row.inflows.empty()) values.push_back(row.entered.total());
  return values;
}

std::vector<std::string> solver_header() {
  return {"time [s]",
          "step [count]",
          "time step [s]",
          "fastest [m/s]",
          "lowest density ratio",
          "highest density ratio",
          "fluid [count]",
          "boundary [count]",
          "sound speed [m/s]",
          "viscous iterations [count]",
          "asleep [count]"};
}

}  // namespace

SeriesTables::SeriesTables(const Scene& scene, const RunFolder& folder)
    : has_dams_(!scene.check_dams().empty()),
      front_(folder.series_file("front.csv"),
             {"time [s]", "position [m]", "displacement [m]", "velocity [m/s]"}),
      discharge_(folder.series_file("discharge.csv"), discharge_header(scene)),
      volumes_(folder.series_file("volumes.csv"), volumes_header(scene)),
      zones_(folder.series_file("zones.csv"), zones_header(scene)),
      energy_(folder.series_file("energy.csv"), energy_header(scene)),
      rest_(folder.series_file("rest.csv"),
            {"time [s]", "moving volume [m3]", "kinetic energy over its peak",
             "creep [spacings/min]"}),
      solver_(folder.series_file("solver.csv"), solver_header()) {}

void SeriesTables::append(const SeriesRow& row) {
  front_.append({row.time, row.front.position, row.front.displacement, row.front.velocity});
  discharge_.append(discharges(row));
  volumes_.append(volumes(row, has_dams_));
  zones_.append(depths(row));
  energy_.append(energies(row));
  rest_.append({row.time, row.motion.moving_volume, row.motion.energy_share, row.motion.creep});
  const SolverRow& step = row.solver;
  solver_.append({row.time, step.steps, step.dt, step.fastest, step.min_density_ratio,
                  step.max_density_ratio, step.fluid, step.boundary, step.sound_speed,
                  step.iterations, step.asleep});
}

}  // namespace sabo
