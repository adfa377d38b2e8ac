#include "run/run_summary.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "run/amount_text.hpp"
#include "run/load_text.hpp"
#include "run/rest_text.hpp"
#include "run/tables.hpp"

namespace sabo {
namespace {

constexpr double doubtful_imbalance = 0.1;  // of the potential energy given up

const char* verb_of(RunEnd end) {
  if (end == RunEnd::failed) return "failed";
  return end == RunEnd::interrupted ? "was interrupted" : "ended";
}

}  // namespace

std::vector<std::string> summary_lines(const RunFacts& facts, const Case& c, const Scene& scene,
                                       const std::vector<SeriesRow>& rows) {
  std::vector<std::string> lines;
  if (facts.end != RunEnd::finished || !facts.reason.empty())
    lines.push_back(fmt::format("The run {} at {:.2f} s of {:g} s{}{}", verb_of(facts.end),
                                facts.solver.simulated, c.run.duration,
                                facts.reason.empty() ? "" : ": ", facts.reason));
  if (facts.end == RunEnd::finished && !facts.motion.is_at_rest)
    lines.push_back("Not at rest at the end: " + motion_text(facts.motion, c.run));
  if (!c.note.empty()) lines.push_back("Note: " + c.note);
  if (!rows.empty())
    for (std::string& line : inflow_lines(scene, rows)) lines.push_back(std::move(line));
  for (const PageTable& table : result_tables(facts, c, scene, rows))
    for (const std::string& line : text_of(table)) lines.push_back(line);
  lines.push_back(fmt::format("Map volume {} m3, particle volume {} m3, difference {:.4f} %",
                              amount_text(facts.raster_volume), amount_text(facts.particle_volume),
                              map_volume_error(facts)));
  if (!rows.empty()) {
    const EnergyBalance energy = balance_of(rows);
    const auto tenths = [&](double part) {
      return std::round(1000 * energy.share(part)) / 10 + 0.0;  // which makes -0 a 0
    };
    lines.push_back(
        fmt::format("Potential energy given up {:.4g} J: {:.1f} % by friction and viscosity, "
                    "{:.1f} % by the scheme itself, {:.2f} % {}",
                    energy.released, tenths(energy.dissipated), tenths(energy.numerical),
                    100 * std::abs(energy.imbalance()),
                    energy.imbalance() > 0 ? "too much is there" : "missing"));
    if (std::abs(energy.imbalance()) > doubtful_imbalance)
      lines.push_back("  energy is not accounted for: try a smaller numerics.spacing and compare");
  }
  lines.push_back(solver_text(facts.solver));
  lines.push_back("Resolution: " + resolution_text(facts.resolution));
  if (const std::string warning = resolution_warning(facts.resolution); !warning.empty())
    lines.push_back("  " + warning);
  // A sound speed that follows the flow is a step behind it.
  if (facts.top_mach > 0.12)
    lines.push_back(fmt::format(
        "Mach number {:.2f}: the fastest particle was above a tenth of the sound speed; "
        "numerics.reference_speed = {:.0f} would keep it below",
        facts.top_mach, facts.top_speed * 10 / c.numerics.sound_speed_factor));
  if (!rows.empty() && rows.back().volumes[0].put_back > 0)
    lines.push_back(
        fmt::format("{} times a particle was found in the ground or a solid and put back",
                    rows.back().volumes[0].put_back));
  return lines;
}

std::vector<PageTable> result_tables(const RunFacts& facts, const Case& c, const Scene& scene,
                                     const std::vector<SeriesRow>& rows) {
  if (rows.empty()) return {};
  std::vector<PageTable> tables = volume_tables(c, scene, rows.back(), facts.basins);
  if (!c.zones.empty()) tables.push_back(zone_table(c, rows.back()));
  if (!facts.loads.empty()) tables.push_back(load_table(facts.loads, c.loads));
  return tables;
}

std::vector<std::string> inflow_lines(const Scene& scene, const std::vector<SeriesRow>& rows) {
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < scene.inflows.size(); ++k) {
    const InflowRow& row = rows.back().inflows[k];
    const double share =
        row.hydrograph > 0 ? 100 * (row.entered - row.hydrograph) / row.hydrograph : 0;
    lines.push_back(fmt::format("Inflow {}: hydrograph {} m3, entered {} m3 ({:+.2f} %)",
                                scene.inflows[k].name, amount_text(row.hydrograph),
                                amount_text(row.entered), share + 0.0));
  }
  return lines;
}

EnergyBalance balance_of(const std::vector<SeriesRow>& rows) {
  const SeriesRow& last = rows.back();
  return energy_balance(rows.front().energy + last.entered, last.energy, last.left, last.dissipated,
                        last.numerical.total());
}

double map_volume_error(const RunFacts& facts) {
  if (!(facts.particle_volume > 0)) return 0;
  const double share = facts.raster_volume / facts.particle_volume - 1;
  return std::round(1e6 * share) / 1e4 + 0.0;  // which makes -0 a 0
}

std::string resolution_text(const ResolutionGuard& guard) {
  return fmt::format(
      "median greatest depth {:.1f} particles; {:.0f} % of the wet area under {:g}, {:.0f} % from "
      "{:g} to {:g}",
      guard.median_layers, 100 * guard.thin_share, ResolutionGuard::enough_layers,
      100 * guard.barely_share, ResolutionGuard::enough_layers, ResolutionGuard::good_layers);
}

std::string resolution_warning(const ResolutionGuard& guard) {
  if (!(guard.wet_area > 0)) return "";
  if (guard.is_too_coarse())
    return "the flow is thinner than its particles resolve: try a smaller numerics.spacing and "
           "compare";
  if (guard.is_barely_enough())
    return fmt::format(
        "the flow is barely resolved, under {:g} particles deep in most places: compare with a "
        "smaller numerics.spacing",
        ResolutionGuard::good_layers);
  return "";
}

}  // namespace sabo
