#include "run/manifest.hpp"

#include <cmath>
#include <ctime>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "base/version.hpp"
#include "io/case_file/toml_string.hpp"
#include "io/case_file/write_case.hpp"
#include "io/output/checksum.hpp"
#include "io/output/cpu_name.hpp"
#include "io/output/file.hpp"
#include "run/amount_text.hpp"
#include "run/file_list.hpp"
#include "run/input_files.hpp"
#include "run/load_text.hpp"
#include "run/rest_text.hpp"
#include "run/scene_record.hpp"
#include "run/tables.hpp"

namespace sabo {
namespace {

constexpr double doubtful_imbalance = 0.1;  // of the potential energy given up

const char* verb_of(RunEnd end) {
  if (end == RunEnd::failed) return "failed";
  return end == RunEnd::interrupted ? "was interrupted" : "ended";
}

std::string volumes(const RunFacts& facts, const Scene& scene, const SeriesRow& last,
                    std::size_t dam) {
  const VolumeRow& row = last.volumes[dam];
  std::string text = fmt::format("released = {:.9g}\noutflow = {:.9g}\nput_back = {}\n",
                                 row.released, row.outflow, row.put_back);
  if (dam < scene.check_dams().size())
    text += fmt::format("dam = {}\ntrapped = {:.9g}\nbeyond = {:.9g}\n",
                        toml_string(scene.dams[dam].name), row.trapped, row.beyond);
  if (dam < facts.basins.size())
    text += fmt::format("stored = {:.9g}\ncapacity = {:.9g}\npool_level = {:.9g}\n",
                        last.basins[dam].stored, facts.basins[dam].capacity(),
                        facts.basins[dam].level());
  return text;
}

/// "upper end: hydrograph 231 m3, entered 231 m3 (-0.02 %)".
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

std::string inflow_text(const InflowPlan& inflow, const InflowRow& row) {
  const SectionFlow peak = inflow.flow_at_peak();
  return fmt::format(
      "\n[[inflow]]\ninflow = {}\nhydrograph = {:.9g}\nentered = {:.9g}\nwhole_hydrograph = "
      "{:.9g}\npeak_discharge = {:.6g}\npeak_time = {:.6g}\npeak_depth = {:.4f}\npeak_speed = "
      "{:.4f}\npeak_level = {:.4f}\n",
      toml_string(inflow.name), row.hydrograph, row.entered, inflow.hydrograph.volume(),
      inflow.hydrograph.discharge[inflow.hydrograph.peak()],
      inflow.hydrograph.time[inflow.hydrograph.peak()], peak.depth, peak.speed, peak.level);
}

std::string zone_text(const ZoneCase& c, const ZoneDepth& zone) {
  return fmt::format(
      "\n[[zones]]\nzone = {}\nmean_wet = {:.4f}\nmean_all = {:.4f}\ngreatest = {:.4f}\n"
      "wet_area = {:.1f}\nvolume = {:.3f}\n",
      toml_string(c.name), zone.mean_wet, zone.mean_all, zone.greatest, zone.wet_area, zone.volume);
}

/// Of the whole run; `rows` are not empty.
EnergyBalance balance_of(const std::vector<SeriesRow>& rows) {
  const SeriesRow& last = rows.back();
  return energy_balance(rows.front().energy + last.entered, last.energy, last.left, last.dissipated,
                        last.numerical.total());
}

std::string energy_text(const EnergyBalance& energy, const NumericalHeat& numerical) {
  return fmt::format(
      "\n[energy]\nreleased_J = {:.9g}\nkinetic_J = {:.9g}\ndissipated_J = {:.9g}\n"
      "artificial_viscosity_J = {:.9g}\ndensity_diffusion_J = {:.9g}\ndensity_hold_J = {:.9g}\n"
      "shifting_J = {:.9g}\nsound_speed_J = {:.9g}\nwalls_J = {:.9g}\ncarried_off_J = "
      "{:.9g}\nimbalance = {:.6f}\n",
      energy.released, energy.kinetic, energy.dissipated, numerical.artificial_viscosity,
      numerical.density_diffusion, numerical.density_hold, numerical.shifting,
      numerical.sound_speed, numerical.walls, energy.carried_off, energy.imbalance());
}

std::string quantities_text(const std::vector<KeyQuantity>& quantities) {
  std::string text = "\n[quantities]\n";
  for (const KeyQuantity& quantity : quantities)
    text += fmt::format("{} = {:.9g}\n", toml_string(quantity.label()), quantity.value);
  return text;
}

/// How far a is from b, in percent to four digits and without a negative zero.
double percent(double a, double b) { return b > 0 ? std::round(1e6 * (a / b - 1)) / 1e4 + 0.0 : 0; }

std::string resolution_text(const ResolutionGuard& guard) {
  return fmt::format(
      "median greatest depth {:.1f} particles; {:.0f} % of the wet area under {:g}, {:.0f} % from "
      "{:g} to {:g}",
      guard.median_layers, 100 * guard.thin_share, ResolutionGuard::enough_layers,
      100 * guard.barely_share, ResolutionGuard::enough_layers, ResolutionGuard::good_layers);
}

/// "" when there is nothing to warn of.
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

std::vector<PageTable> result_tables(const RunFacts& facts, const Case& c, const Scene& scene,
                                     const std::vector<SeriesRow>& rows) {
  if (rows.empty()) return {};
  std::vector<PageTable> tables = volume_tables(c, scene, rows.back(), facts.basins);
  if (!c.zones.empty()) tables.push_back(zone_table(c, rows.back()));
  if (!facts.loads.empty()) tables.push_back(load_table(facts.loads, c.loads));
  return tables;
}

}  // namespace

std::string input_checksums(const Case& c) {
  std::string text = "\n[inputs]  # CRC-32\n";
  for (const std::filesystem::path& file : input_files(c))
    text += toml_string(file.string()) + " = " + toml_string(checksum(file)) + "\n";
  return text;
}

std::string utc_now() {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
}

void write_manifest(const RunFacts& facts, const Case& c, const Scene& scene,
                    const std::vector<SeriesRow>& rows, const RunFolder& folder) {
  std::string text = fmt::format(
      "# Written by sabo. Units: m, s, m3.\n"
      "run_folder_version = {}\n\n[run]\nend = {}\nreason = {}\nversion = {}\ncompiler = {}\n"
      "machine = {}\nstarted = {}\nwall_s = {:.1f}\nsimulated_s = {:.6g}\nsteps = {}\nparticles = "
      "{}\n"
      "boundary_particles = {}\ntop_speed = {:.3f}\nsound_speed = {:.3f}\n",
      run_folder_version, toml_string(std::string(word_of(facts.end))), toml_string(facts.reason),
      toml_string(build_version), toml_string(build_compiler), toml_string(cpu_name()),
      toml_string(facts.started), facts.solver.wall, facts.solver.simulated, facts.solver.steps,
      facts.particles, facts.boundary_particles, facts.top_speed, facts.sound_speed);
  if (!facts.resumed.empty())
    text += fmt::format("resumed_s = [{:.6g}]\n", fmt::join(facts.resumed, ", "));
  if (!facts.branched_from.empty())
    text += fmt::format("branched_from = {}\nbranched_at_s = {:.6g}\n",
                        toml_string(facts.branched_from), facts.branched_at);
  text += scene_toml(c, scene);
  if (!rows.empty())
    for (std::size_t k = 0; k < rows.back().volumes.size(); ++k)
      text += "\n[[volumes]]\n" + volumes(facts, scene, rows.back(), k);
  if (!rows.empty())
    for (std::size_t k = 0; k < scene.inflows.size(); ++k)
      text += inflow_text(scene.inflows[k], rows.back().inflows[k]);
  if (!rows.empty())
    for (std::size_t k = 0; k < c.zones.size(); ++k)
      text += zone_text(c.zones[k], rows.back().zones[k]);
  text += loads_toml(facts.loads, c.loads);
  text += fmt::format(
      "\n[maps]\nraster_volume = {:.3f}\nparticle_volume = {:.3f}\n"
      "\n[resolution]\nwet_area = {:.1f}\nmedian_layers = {:.2f}\nthin_share = {:.3f}\n"
      "barely_share = {:.3f}\nwarning = {}\n",
      facts.raster_volume, facts.particle_volume, facts.resolution.wet_area,
      facts.resolution.median_layers, facts.resolution.thin_share, facts.resolution.barely_share,
      toml_string(resolution_warning(facts.resolution)));
  text += fmt::format(
      "\n[motion]\nat_rest = {}\nmoving_volume = {:.3f}\nkinetic_energy_over_peak = {:.3g}\n"
      "creep = {:.4g}\n",
      facts.motion.is_at_rest, facts.motion.moving_volume, facts.motion.energy_share,
      facts.motion.creep);
  if (!rows.empty()) text += energy_text(balance_of(rows), rows.back().numerical);
  text += quantities_text(facts.quantities);
  text += solver_toml(facts.solver) + passes_toml(facts.passes);
  write_file_atomically(folder.root() / "case.toml", write_case(c));
  write_file_atomically(folder.manifest(), text + input_checksums(c));
}

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
                              percent(facts.raster_volume, facts.particle_volume)));
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

namespace {

/// The method with the choices that decide how the ground holds the flow.
std::string method_text(const NumericsCase& numerics) {
  const std::string_view method = word_of(numerics.method);
  if (numerics.method == Method::fast)
    return fmt::format("{}, wall {}", method, word_of(numerics.wall));
  return fmt::format("{}, viscous operator {}, boundary stress {}", method,
                     word_of(numerics.viscous_operator), word_of(numerics.boundary_stress));
}

}  // namespace

IndexPage index_page(const RunFacts& facts, const Case& c, const Scene& scene,
                     const std::vector<SeriesRow>& rows, std::vector<PagePicture> pictures) {
  IndexPage page;
  page.title = c.title.empty() ? "Debris flow" : c.title;
  page.subtitle =
      fmt::format("sabo {} · {} · {}", build_version, facts.started, word_of(facts.end));
  page.note = c.note;
  page.facts = {
      {"Simulated", fmt::format("{:.1f} s of {:g} s in {:.0f} s of computing",
                                facts.solver.simulated, c.run.duration, facts.solver.wall)},
      {"Steps", solver_text(facts.solver)},
      {"Particles", fmt::format("{} of the flow, spacing {:g} m; {} of the ground at the end",
                                facts.particles, c.numerics.spacing, facts.boundary_particles)},
      {"Material",
       fmt::format("{} law, density {:g} kg/m3, friction angle {:g} deg, cohesion "
                   "{:g} Pa, pore pressure ratio {:g}",
                   name_of(c.material.law), c.material.density, c.material.yield.friction_angle,
                   c.material.yield.cohesion, c.material.yield.pore_pressure_ratio)},
      {"Method", method_text(c.numerics)},
      {"Fastest particle",
       fmt::format("{:.1f} m/s (Mach number at most {:.2f})", facts.top_speed, facts.top_mach)},
      {"Resolution", resolution_text(facts.resolution)},
      {"Map volume",
       fmt::format("{} m3, {:+.4f} % of the particles'", amount_text(facts.raster_volume),
                   percent(facts.raster_volume, facts.particle_volume))}};
  if (!facts.motion.is_at_rest)
    page.facts.insert(page.facts.begin() + 1, {"Not at rest", motion_text(facts.motion, c.run)});
  if (!facts.branched_from.empty())
    page.facts.insert(page.facts.begin(),
                      {"Starts", fmt::format("with the state of {} at {:.1f} s",
                                             facts.branched_from, facts.branched_at)});
  if (!facts.reason.empty()) page.facts.insert(page.facts.begin(), {"Stopped", facts.reason});
  if (!rows.empty())
    for (std::string& line : inflow_lines(scene, rows))
      page.facts.push_back({"Inflow", line.substr(line.find(' ') + 1)});
  page.warning = resolution_warning(facts.resolution);
  page.tables = result_tables(facts, c, scene, rows);
  page.details = {parameter_table(c), pass_table(facts.passes)};
  page.pictures = std::move(pictures);
  page.files = files_of_run(c, scene);
  return page;
}

}  // namespace sabo
