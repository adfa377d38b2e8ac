#include "run/simulation.hpp"

#include <algorithm>
#include <chrono>
#include <memory>
#include <new>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/version.hpp"
#include "io/output/cpu_name.hpp"
#include "run/checkpoints.hpp"
#include "run/conclusion.hpp"
#include "run/flow.hpp"
#include "run/frames.hpp"
#include "run/manifest.hpp"
#include "run/recorder.hpp"
#include "run/rest_text.hpp"
#include "run/resume.hpp"
#include "run/run_folder.hpp"
#include "run/scene_record.hpp"
#include "solver/make_backend.hpp"

namespace sabo {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// One run from its first step to its page.
class Simulation {
 public:
  Simulation(const Case& c, const Scene& scene, const RunFolder& folder, const RunOptions& options,
             const BranchStart& start)
      : case_(c),
        scene_(scene),
        options_(options),
        flow_(c, scene, start.fluid, scene.inflows),
        folder_(folder),
        recorder_(c, scene, flow_.model(), folder_),
        frames_(scene, folder_, flow_.model().threads),
        checkpoints_(folder.checkpoints()),
        head_(checkpoint_head(c, scene)),
        row_due_(start.time),
        frame_due_(start.time),
        kept_due_(start.time) {
    flow_.stepper().start_at(start.time);
    recorder_.start(start.time, start.fluid, scene.release);
    if (options.branch) {
      facts_.branched_from = options.branch->run_folder.string();
      facts_.branched_at = start.time;
    }
    facts_.started = utc_now();
    facts_.sound_speed = flow_.model().state.c0;
  }

  /// Goes on from a checkpoint. Throws RunError when it does not fit; this simulation is of no more
  /// use then.
  void load(const FoundCheckpoint& checkpoint) {
    read_state_file(checkpoint.file, checkpoint_version).read([this](ArchiveReader& a) {
      CheckpointHead head;
      a(head);
      archive(a);
    });
    recorder_.follow(flow_.backend().fluid());
    facts_.resumed.push_back(flow_.stepper().time());
  }

  RunResult run() {
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
    recorder_.after_renewal(flow_.domain(), flow_.backend().model().state);
    while (true) {
      const double time = flow_.stepper().time();
      const bool is_empty =
          flow_.backend().fluid_count() == 0 && flow_.domain().inflows_are_over(time);
      const bool is_at_rest = case_.run.stop_at_rest && recorder_.motion().is_at_rest;
      const bool is_over = time >= duration || is_empty || is_at_rest;
      // An inflow that has just changed the particles is left a step, so that it can be resumed.
      const bool is_stopped =
          options_.stop && *options_.stop && !flow_.stepper().neighbours_are_due();
      // Before the last row and frame, which would not be there had the run not ended here.
      if (is_over || is_stopped) write_checkpoint(false);
      if (time >= row_due_ || is_over || is_stopped) {
        const FlowHealth health = flow_.backend().health();
        const PassClock clock(recording_, "series and maps");
        recorder_.write_row(flow_.stepper(), report_, health, flow_.backend());
        row_due_ += case_.run.series_interval;
      }
      if (time >= frame_due_ || is_over || is_stopped) {
        const PassClock clock(recording_, "frames");
        recorder_.settle();  // first, so that a row which ends the run comes without a frame
        frames_.write(time, flow_.backend());
        frame_due_ += case_.run.output_interval;
      }
      if (is_stopped && !is_over) facts_.end = RunEnd::interrupted;
      if (time < duration && is_empty) facts_.reason = "all of the flow has left the map";
      if (time < duration && is_at_rest && !is_empty)
        facts_.reason = rest_reason(recorder_.motion(), case_.run);
      if (is_over || is_stopped) return settle();
      write_due_checkpoint();

      report_ = flow_.stepper().step(duration - time);
      count_step();
      record_step();
      tell_progress();
    }
  }

  /// Waits for what is done beside the steps. What it throws ends the run.
  void settle() {
    recorder_.settle();
    frames_.settle();
  }

  void record_step() {
    const PassClock clock(recording_, "series and maps");
    recorder_.after_entry(flow_.domain(), flow_.backend().model().state);
    recorder_.after_step(flow_.stepper(), report_, flow_.backend());
    recorder_.after_renewal(flow_.domain(), flow_.backend().model().state);
  }

  void count_step() {
    facts_.top_speed = std::max(facts_.top_speed, report_.flow.speed);
    facts_.sound_speed = std::max(facts_.sound_speed, report_.sound_speed);
    facts_.top_mach = std::max(facts_.top_mach, report_.flow.speed / report_.sound_speed);
    facts_.solver.iterations += static_cast<std::uint64_t>(report_.iterations);
  }

  /// Of computing, with that before a checkpoint, s.
  double wall() const { return wall_before_ + seconds_since(start_); }

  /// All that later steps and outputs depend on.
  template <class Archive>
  void archive(Archive& a) {
    double wall_so_far = wall();
    a(flow_);  // first, for branch_start()
    a.mark("run");
    a(facts_.started, facts_.branched_from, facts_.branched_at, facts_.top_speed,
      facts_.sound_speed, facts_.top_mach, facts_.solver.iterations, facts_.resumed, wall_so_far,
      row_due_, frame_due_, kept_due_, report_, recording_);
    a(recorder_, frames_);
    if constexpr (Archive::is_reader) {
      wall_before_ = wall_so_far;
      start_ = checkpointed_ = Clock::now();
    }
  }

  void write_due_checkpoint() {
    if (flow_.stepper().neighbours_are_due()) return;
    const double interval = case_.run.checkpoint_interval;
    const double kept_interval = case_.run.kept_checkpoint_interval;
    const bool is_kept = kept_interval > 0 && flow_.stepper().time() >= kept_due_;
    while (is_kept && kept_due_ <= flow_.stepper().time()) kept_due_ += kept_interval;
    // The last step may leave no state to go on from, if an inflow changes the particles then.
    const bool is_last = !flow_.domain().inflows().empty() &&
                         case_.run.duration - flow_.stepper().time() < 2 * report_.dt;
    if (is_kept || is_last || (interval > 0 && seconds_since(checkpointed_) >= interval))
      write_checkpoint(is_kept);
  }

  /// A run goes on without one that cannot be written.
  void write_checkpoint(bool is_kept) {
    if (case_.run.checkpoint_interval == 0 || flow_.stepper().neighbours_are_due()) return;
    settle();
    head_.time = flow_.stepper().time();
    head_.steps = flow_.stepper().steps();
    try {
      checkpoints_.write(head_, is_kept, [this](ArchiveWriter& a) { archive(a); });
    } catch (const RunError& error) {
      options_.on_note(std::string("warning: no checkpoint: ") + error.what());
    }
    checkpointed_ = Clock::now();
  }

  /// Writes the state that a run failed in as its last frame, if it can be written at all. What has
  /// failed beside the steps since the last look at it came first.
  void show_failure() {
    try {
      recorder_.settle();
    } catch (const RunError& earlier) {
      facts_.reason = fmt::format("{}; {}", earlier.what(), facts_.reason);
    }
    const auto told = [this](const char* frame, const std::function<void()>& write) {
      try {
        write();
      } catch (const RunError& error) {
        facts_.reason += fmt::format("; {} could not be written: {}", frame, error.what());
      }
    };
    told("an earlier frame", [this] { frames_.settle(); });
    told("its last frame", [this] {
      frames_.write(flow_.stepper().time(), flow_.backend());
      frames_.settle();
    });
  }

  void tell_progress() {
    if (!options_.on_progress || seconds_since(told_) < options_.progress_interval) return;
    told_ = Clock::now();
    RunProgress progress{flow_.stepper().time(),
                         case_.run.duration,
                         wall(),
                         flow_.stepper().steps(),
                         report_.dt,
                         flow_.backend().fluid_count(),
                         flow_.backend().boundary_count(),
                         report_.flow.speed,
                         {},
                         {}};
    if (!recorder_.rows().empty()) {
      progress.front = recorder_.rows().back().front;
      progress.volumes = recorder_.rows().back().volumes.front();
    }
    options_.on_progress(progress);
  }

  RunResult conclude() {
    facts_.solver.wall = wall();
    facts_.solver.simulated = flow_.stepper().time();
    facts_.solver.steps = flow_.stepper().steps();
    PassTimes passes = flow_.backend().pass_times();
    for (const PassTime& pass : recording_.passes()) passes[pass.name] = pass;
    facts_.passes = pass_shares(passes, facts_.solver.wall);
    RunResult result = Conclusion(case_, scene_, folder_, flow_, recorder_, facts_).write();
    if (facts_.end == RunEnd::finished) checkpoints_.keep(options_.keeps_checkpoint ? 1 : 0);
    return result;
  }

  const Case& case_;
  const Scene& scene_;
  const RunOptions& options_;
  Flow flow_;
  const RunFolder& folder_;
  Recorder recorder_;
  Frames frames_;
  RunFacts facts_;
  CheckpointWriter checkpoints_;
  CheckpointHead head_;
  StepReport report_;                      // of the last step
  PassTimes recording_;                    // what the steps wait for
  double row_due_, frame_due_, kept_due_;  // s
  double wall_before_ = 0;                 // s
  Clock::time_point start_ = Clock::now();
  Clock::time_point told_ = start_;
  Clock::time_point checkpointed_ = start_;
};

/// "" where the bits will be those of a run that was never stopped.
std::string checkpoint_note(const CheckpointHead& head) {
  std::string note;
  if (head.program != build_version) note += fmt::format(", written by sabo {}", head.program);
  if (head.machine != cpu_name()) note += fmt::format(", written on {}", head.machine);
  return note.empty() ? "" : note + ": last digits may differ from those of a run without a stop";
}

/// The run in a folder from the latest of some checkpoints that fits.
std::unique_ptr<Simulation> resumed(const Case& c, const Scene& scene, const RunFolder& folder,
                                    const RunOptions& options,
                                    const std::vector<FoundCheckpoint>& checkpoints) {
  for (const FoundCheckpoint& checkpoint : checkpoints) {
    try {
      auto simulation =
          std::make_unique<Simulation>(c, scene, folder, options, BranchStart{0, scene.release});
      simulation->load(checkpoint);
      options.on_note(fmt::format("Goes on from {:.6g} s, {}{}", checkpoint.head.time,
                                  checkpoint.file.string(), checkpoint_note(checkpoint.head)));
      return simulation;
    } catch (const RunError& error) {
      options.on_note(
          fmt::format("warning: {} cannot be used: {}", checkpoint.file.string(), error.what()));
    }
  }
  throw RunError(
      "no checkpoint can be used: what the run had computed is lost; start anew with "
      "--overwrite");
}

}  // namespace

RunResult run_case(const Case& c, const RunOptions& given) {
  require_backend(c.numerics.backend);
  RunOptions options = given;
  if (!options.on_note) options.on_note = [](const std::string&) {};
  const bool goes_on = options.former == FormerRun::resumed;
  std::vector<FoundCheckpoint> checkpoints;
  if (goes_on) checkpoints = checkpoints_to_resume(c, options.folder, options.on_note);
  Faults faults;
  const Scene scene = make_scene(c, faults);
  faults.throw_if_any();
  BranchStart start{0, scene.release};
  if (options.branch) start = branch_start(c, scene, *options.branch, options.on_note);
  const RunFolder folder(options.folder, options.former);
  try {
    write_scene_record(c, scene, folder);
    if (goes_on) return resumed(c, scene, folder, options, checkpoints)->run();
    return Simulation(c, scene, folder, options, start).run();
  } catch (const CaseError& error) {  // of what is laid out from the scene
    folder.set_state("failed", error.what());
    throw;
  } catch (const RunError& error) {
    folder.set_state("failed", error.what());
    throw;
  } catch (const std::bad_alloc&) {
    folder.set_state("failed", "not enough memory");
    throw;
  }
}

}  // namespace sabo
