#include "run/simulation.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "io/output/file.hpp"
#include "run/flow.hpp"
#include "run/frames.hpp"
#include "run/manifest.hpp"
#include "run/pictures.hpp"
#include "run/recorder.hpp"
#include "run/rest_text.hpp"
#include "run/run_folder.hpp"
#include "run/scene_record.hpp"
#include "run/view.hpp"

namespace sabo {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// One run from its first step to its page.
class Simulation {
 public:
  Simulation(const Case& c, const Scene& scene, const RunFolder& folder, const RunOptions& options)
      : case_(c),
        scene_(scene),
        options_(options),
        flow_(c, scene),
        folder_(folder),
        recorder_(c, scene, flow_.model(), folder_),
        frames_(scene, folder_) {}

  RunResult run() {
    facts_.started = utc_now();
    facts_.sound_speed = flow_.model().state.c0;
    try {
      simulate();
    } catch (const RunError& error) {
      facts_.end = RunEnd::failed;
      facts_.reason = error.what();
      show_failure();
    }
    return conclude();
  }

 private:
  /// Steps until the end, writing series and frames when they are due.
  void simulate() {
    const double duration = case_.run.duration;
    double row_due = 0;
    double frame_due = 0;
    StepReport report;
    recorder_.after_renewal(flow_.domain(), flow_.backend().model().state);
    while (true) {
      const double time = flow_.stepper().time();
      const bool is_empty =
          flow_.backend().fluid().size() == 0 && flow_.domain().inflows_are_over(time);
      const bool is_at_rest = case_.run.stop_at_rest && recorder_.motion().is_at_rest;
      const bool is_over = time >= duration || is_empty || is_at_rest;
      const bool is_stopped = options_.stop && *options_.stop;
      if (time >= row_due || is_over || is_stopped) {
        recorder_.write_row(flow_.stepper(), report, flow_.backend());
        row_due += case_.run.series_interval;
      }
      if (time >= frame_due || is_over || is_stopped) {
        frames_.write(time, flow_.backend().fluid());
        frame_due += case_.run.output_interval;
      }
      if (is_stopped && !is_over) facts_.end = RunEnd::interrupted;
      if (time < duration && is_empty) facts_.reason = "all of the flow has left the map";
      if (time < duration && is_at_rest && !is_empty)
        facts_.reason = rest_reason(recorder_.motion(), case_.run);
      if (is_over || is_stopped) return;

      report = flow_.stepper().step(duration - time);
      facts_.top_speed = std::max(facts_.top_speed, report.flow.speed);
      facts_.sound_speed = std::max(facts_.sound_speed, report.sound_speed);
      facts_.top_mach = std::max(facts_.top_mach, report.flow.speed / report.sound_speed);
      facts_.solver.iterations += static_cast<std::uint64_t>(report.iterations);
      recorder_.after_entry(flow_.domain(), flow_.backend().model().state);
      recorder_.after_step(flow_.stepper(), report, flow_.backend());
      recorder_.after_renewal(flow_.domain(), flow_.backend().model().state);
      tell_progress(report);
    }
  }

  /// Writes the state that a run failed in as its last frame, if it can be written at all.
  void show_failure() {
    try {
      frames_.write(flow_.stepper().time(), flow_.backend().fluid());
    } catch (const RunError& error) {
      facts_.reason += std::string("; its last frame could not be written: ") + error.what();
    }
  }

  void tell_progress(const StepReport& report) {
    if (!options_.on_progress || seconds_since(told_) < 0.2) return;
    told_ = Clock::now();
    RunProgress progress{flow_.stepper().time(),
                         case_.run.duration,
                         seconds_since(start_),
                         flow_.stepper().steps(),
                         report.dt,
                         flow_.backend().fluid().size(),
                         flow_.backend().boundary().size(),
                         report.flow.speed,
                         {},
                         {}};
    if (!recorder_.rows().empty()) {
      progress.front = recorder_.rows().back().front;
      progress.volumes = recorder_.rows().back().volumes.front();
    }
    options_.on_progress(progress);
  }

  /// Writes maps, pictures, page and manifest of whatever was reached.
  RunResult conclude() {
    // A state that failed must not leave its mark on the maps.
    if (facts_.end != RunEnd::failed)
      recorder_.finish(flow_.stepper().time(), flow_.backend().fluid());
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
      write_file_atomically(folder_.index(), index_html(index_page(facts_, case_, scene_, rows,
                                                                   std::move(pictures))));
      result.index = folder_.index();
    });
    attempt([&] { write_from_frames(folder_.root(), case_, scene_); });
    attempt([&] { write_manifest(facts_, case_, scene_, rows, folder_); });
    result.end = facts_.end;
    result.reason = facts_.reason;
    result.summary = summary_lines(facts_, case_, scene_, rows);
    return result;
  }

  /// Writes one part of the results. The run has failed if that fails, for the first such reason.
  void attempt(const std::function<void()>& part) {
    try {
      part();
    } catch (const RunError& error) {
      if (facts_.end != RunEnd::failed) facts_.reason = error.what();
      facts_.end = RunEnd::failed;
    }
  }

  void fill_facts(const RunMaps& maps) {
    facts_.particles = scene_.release.size();
    for (const Inflow& inflow : flow_.domain().inflows()) facts_.particles += inflow.count();
    facts_.solver.wall = seconds_since(start_);
    facts_.solver.simulated = flow_.stepper().time();
    facts_.solver.steps = flow_.stepper().steps();
    facts_.passes = pass_shares(flow_.backend().pass_times(), facts_.solver.wall);
    facts_.motion = recorder_.motion();
    facts_.loads = recorder_.loads();
    facts_.basins = recorder_.basins();
    facts_.boundary_particles = flow_.backend().boundary().size();
    facts_.resolution = resolution_guard(maps.peak_depth, flow_.model().spacing);
    for (const double mass : flow_.backend().fluid().mass)
      facts_.particle_volume += mass / flow_.model().state.rho0;
    for (const double depth : maps.deposit.values)
      if (!std::isnan(depth)) facts_.raster_volume += depth * maps.deposit.grid.cell_area();
  }

  const Case& case_;
  const Scene& scene_;
  const RunOptions& options_;
  Flow flow_;
  const RunFolder& folder_;
  Recorder recorder_;
  Frames frames_;
  RunFacts facts_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point told_ = start_;
};

}  // namespace

RunResult run_case(const Case& c, const RunOptions& options) {
  Faults faults;
  const Scene scene = make_scene(c, faults);
  faults.throw_if_any();
  const RunFolder folder(options.folder, options.overwrite);
  try {
    write_scene_record(c, scene, folder);
    return Simulation(c, scene, folder, options).run();
  } catch (const RunError& error) {
    folder.set_state("failed", error.what());
    throw;
  }
}

}  // namespace sabo
