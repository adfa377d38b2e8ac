#include "run/conclusion.hpp"

#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "io/output/file.hpp"
#include "run/manifest.hpp"
#include "run/pictures.hpp"
#include "run/run_page.hpp"
#include "run/run_summary.hpp"
#include "run/view.hpp"

namespace sabo {

RunResult Conclusion::write() {
  attempt([&] { recorder_.settle(); });
  // A state that failed must not leave its mark on the maps.
  if (facts_.end != RunEnd::failed)
    attempt([&] { recorder_.finish(flow_.stepper().time(), flow_.backend().fluid()); });
  const FlowMaps& flow = recorder_.maps();
  const double spacing = flow_.model().spacing;
  const RunMaps maps{flow.depth(),
                     flow.peak_depth(),
                     flow.peak_speed(),
                     flow.peak_pressure(),
                     flow.peak_momentum_flux(),
                     flow.arrival_time(),
                     layers_map(flow.peak_depth(), spacing),
                     wet_depth(spacing)};
  const std::vector<SeriesRow>& rows = recorder_.rows();
  fill_facts(maps);
  facts_.quantities = key_quantities(maps, rows, scene_);

  RunResult result;
  attempt([&] { folder_.set_state("failed", "the outputs are incomplete"); });
  attempt([&] { write_maps(maps, case_, scene_, folder_); });
  attempt([&] {
    auto pictures = draw_pictures(maps, rows, facts_.loads, case_, scene_, folder_);
    write_file_atomically(folder_.index(),
                          index_html(index_page(facts_, case_, scene_, rows, std::move(pictures))));
    result.index = folder_.index();
  });
  attempt([&] { write_from_frames(folder_.root(), case_, scene_); });
  attempt([&] { write_manifest(facts_, case_, scene_, rows, folder_); });
  result.end = facts_.end;
  result.reason = facts_.reason;
  result.summary = summary_lines(facts_, case_, scene_, rows);
  return result;
}

/// The run has failed for the first reason.
void Conclusion::attempt(const std::function<void()>& part) {
  try {
    part();
  } catch (const RunError& error) {
    if (facts_.end != RunEnd::failed) facts_.reason = error.what();
    facts_.end = RunEnd::failed;
  }
}

void Conclusion::fill_facts(const RunMaps& maps) {
  facts_.particles = scene_.release.size();
  for (const Inflow& inflow : flow_.domain().inflows()) facts_.particles += inflow.count();
  facts_.motion = recorder_.motion();
  facts_.loads = recorder_.loads();
  facts_.basins = recorder_.basins();
  facts_.boundary_particles = flow_.backend().boundary_count();
  facts_.resolution = resolution_guard(maps.peak_depth, flow_.model().spacing);
  attempt([&] {
    for (const double mass : flow_.backend().fluid().mass)
      facts_.particle_volume += mass / flow_.model().state.rho0;
  });
  for (const double depth : maps.deposit.values)
    if (!std::isnan(depth)) facts_.raster_volume += depth * maps.deposit.grid.cell_area();
}

}  // namespace sabo
