#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "analysis/section.hpp"
#include "analysis/tracks.hpp"
#include "analysis/volume_ledger.hpp"
#include "base/background.hpp"
#include "run/flow_meter.hpp"
#include "run/load_account.hpp"
#include "run/run_folder.hpp"
#include "run/scene.hpp"
#include "solver/domain.hpp"
#include "solver/stepper.hpp"

namespace sabo {

/// Measures a run while it goes on and writes the series. Where the fluid is on a device of its
/// own, what has to see all of it is done beside the steps, at a copy: rows and maps lag behind
/// until settle().
class Recorder {
 public:
  Recorder(const Case& c, const Scene& scene, const FlowModel& model, const RunFolder& folder);

  /// To be called first. A flow that starts on its way counts as if its particles had come straight
  /// from where they were released, and those that it lacks had left the map.
  void start(double time, const Particles& fluid, const Particles& release);

  /// Takes in what has come through inflows; to be called after every step, before after_step().
  void after_entry(Domain& domain, const Tait& state);

  /// To be called after every step: counts crossings and samples the maps each time the fastest
  /// particle has moved by a cell or a spacing, whichever is larger.
  void after_step(const Stepper& stepper, const StepReport& report, Backend& backend);

  /// Particles that left the domain and those put back on the ground since the last call.
  void after_renewal(Domain& domain, const Tait& state);

  /// Appends a row to every series; `health` is that of now. Throws RunError, before it does, when
  /// the flow has more energy than it can have; where rows lag behind, settle() or the next look at
  /// the fluid does.
  void write_row(const Stepper& stepper, const StepReport& report, const FlowHealth& health,
                 Backend& backend);

  /// Waits until all that was seen is in rows and maps. Throws RunError when it could not be.
  void settle();

  /// Takes the last state into the maps.
  void finish(double time, const Particles& fluid);

  /// Those that are there so far.
  const std::vector<SeriesRow>& rows() const { return rows_; }
  /// May be that of an earlier look as long as the flow is not at rest.
  const MotionState& motion() const { return motion_; }

  // Once all is settled.
  const FlowMaps& maps() const { return meter_.maps(); }
  const std::vector<Basin>& basins() const { return meter_.basins(); }
  const std::vector<LoadSummary>& loads() const { return meter_.loads(); }

  /// Without the tracks, see follow().
  template <class Archive>
  void archive(Archive& a) {
    settle();
    a.mark("recorder");
    a.fixed(sections_);
    a.fixed(ledgers_);
    a(load_account_, meter_, rest_due_, travelled_, unseen_, put_back_seen_, left_, freed_, pushed_,
      rows_);
    if (unseen_ > 0) a(tracks_);
    a.fixed(inflows_);
    settle();  // what was read
  }

  /// After archive(): paths of particles start where they are unless there has been a step since
  /// the last look at them. Throws RunError for particles that were never released.
  void follow(const Particles& fluid);

 private:
  void look(double time, Backend& backend);
  bool take_rest_due(double time);
  void show(double time, Backend& backend, const std::function<void(const Particles&)>& measure);
  RowStart start_of_row(const Stepper& stepper, const StepReport& report, const FlowHealth& health,
                        Backend& backend);

  Method method_;
  bool may_stop_at_rest_;
  int threads_;
  double density_;  // kg/m3
  Tracks tracks_;
  std::vector<Section> sections_;
  std::vector<VolumeLedger> ledgers_;
  LoadAccount load_account_;
  double sampling_distance_;  // m
  double look_distance_;      // m
  double unseen_ = 0;         // way of the fastest particle since the tracks were advanced, m
  double travelled_ = 0;      // by the fastest particle since the maps were sampled, m
  double rest_due_ = 0;       // when the watch for rest has to see the particles, s
  std::size_t put_back_seen_ = 0;
  std::vector<InflowRow> inflows_;
  std::vector<const InflowPlan*> inflow_plans_;
  Energy freed_;       // of what inflows have set free, at the time they did
  double pushed_ = 0;  // work of what pushed that, J
  Energy left_;
  std::vector<SeriesRow> rows_;
  MotionState motion_;

  // What changes of these is left to what goes on beside the steps until that is settled.
  FlowMeter meter_;
  std::optional<SeriesRow> written_;
  Background measuring_;  // the last: it ends before what it works on
};

}  // namespace sabo
