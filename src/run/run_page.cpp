#include "run/run_page.hpp"

#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/version.hpp"
#include "run/amount_text.hpp"
#include "run/file_list.hpp"
#include "run/rest_text.hpp"
#include "run/run_summary.hpp"
#include "run/tables.hpp"

namespace sabo {
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
      {"Map volume", fmt::format("{} m3, {:+.4f} % of the particles'",
                                 amount_text(facts.raster_volume), map_volume_error(facts))}};
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
