#include "run/manifest.hpp"

#include <ctime>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "base/version.hpp"
#include "io/case_file/toml_string.hpp"
#include "io/output/checksum.hpp"
#include "io/output/cpu_name.hpp"
#include "io/output/file.hpp"
#include "run/input_files.hpp"
#include "run/load_text.hpp"
#include "run/run_summary.hpp"
#include "run/scene_record.hpp"

namespace sabo {
namespace {

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
  write_file_atomically(folder.manifest(), text + input_checksums(c));
}

}  // namespace sabo
