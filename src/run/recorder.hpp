#pragma once

#include <vector>

#include "analysis/energy.hpp"
#include "analysis/flow_maps.hpp"
#include "analysis/front.hpp"
#include "analysis/rest.hpp"
#include "analysis/section.hpp"
#include "analysis/tracks.hpp"
#include "analysis/volume_ledger.hpp"
#include "analysis/zone.hpp"
#include "base/background.hpp"
#include "io/output/csv.hpp"
#include "run/dam_fillings.hpp"
#include "run/gauges.hpp"
#include "run/run_folder.hpp"
#include "run/scene.hpp"
#include "run/section_states.hpp"
#include "run/structure_loads.hpp"
#include "solver/domain.hpp"
#include "solver/stepper.hpp"

namespace sabo {

/// What has come through an inflow since the start.
struct InflowRow {
  double entered = 0;     ///< m3
  double hydrograph = 0;  ///< m3 that its hydrograph has brought by then

  template <class Archive>
  void archive(Archive& a) {
    a(entered, hydrograph);
  }
};

/// One row of the series, kept for the pictures; discharge has one entry per section.
struct SeriesRow {
  double time = 0;
  FrontRow front;
  std::vector<double> discharge;   ///< net, mean since the row before, m3/s
  std::vector<VolumeRow> volumes;  ///< one entry per check dam, or one alone without
  std::vector<ZoneDepth> zones;    ///< one entry per zone
  std::vector<BasinState> basins;  ///< one entry per check dam
  std::vector<LoadRow> loads;      ///< one entry per structure, then per body
  std::vector<InflowRow> inflows;  ///< one entry per inflow
  Energy energy;
  Energy entered;         ///< brought by inflows so far
  Energy left;            ///< of what has left the map, at the time it did
  double dissipated = 0;  ///< J
  NumericalHeat numerical;
  MotionState motion;

  template <class Archive>
  void archive(Archive& a) {
    a(time, front, discharge, volumes, zones, basins, loads, inflows, energy, entered, left,
      dissipated, numerical, motion);
  }
};

/// Measures a run while it goes on and writes the series.
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
  /// the flow has more energy than it can have.
  void write_row(const Stepper& stepper, const StepReport& report, const FlowHealth& health,
                 Backend& backend);

  /// Waits until all that was sampled is in the maps. Throws RunError when it could not be copied.
  void settle() { mapping_.settle(); }

  /// Takes the last state into the maps.
  void finish(double time, const Particles& fluid);

  const std::vector<SeriesRow>& rows() const { return rows_; }
  /// Of all that was sampled.
  const FlowMaps& maps();
  const MotionState& motion() const { return rest_.state(); }
  const std::vector<Basin>& basins() const { return fillings_.basins(); }
  std::vector<LoadSummary> loads() const { return loads_.summaries(); }

  /// Without the tracks, see follow().
  template <class Archive>
  void archive(Archive& a) {
    mapping_.settle();
    a.mark("recorder");
    a.fixed(sections_);
    a.fixed(ledgers_);
    a(section_states_, gauges_, fillings_, loads_, front_, rest_, maps_, travelled_, unseen_,
      put_back_seen_, left_, freed_, pushed_, rows_);
    if (unseen_ > 0) a(tracks_);
    a.fixed(inflows_);
    a(front_csv_, discharge_csv_, volumes_csv_, zones_csv_, energy_csv_, rest_csv_, solver_csv_);
  }

  /// After archive(): paths of particles start where they are unless there has been a step since
  /// the last look at them. Throws RunError for particles that were never released.
  void follow(const Particles& fluid);

 private:
  Energy energy_in(const Particles& fluid, const Tait& state) const;
  void look(double time, Backend& backend);
  void sample_maps(double time, Backend& backend);
  void check_energy(const SeriesRow& row) const;
  void write_zones(SeriesRow& row);
  void write_solver_row(const Stepper& stepper, const StepReport& report, const FlowHealth& health,
                        const Backend& backend);

  FlowModel model_;
  Method method_;
  Tracks tracks_;
  std::vector<Section> sections_;
  std::vector<Zone> zones_;
  Columns columns_;  // of the rows: those of the maps are sampled at other times
  std::vector<VolumeLedger> ledgers_;
  SectionStates section_states_;
  Gauges gauges_;
  DamFillings fillings_;
  StructureLoads loads_;
  Front front_;
  RestWatch rest_;
  FlowMaps maps_;
  double sampling_distance_;  // m
  double look_distance_;      // m
  double unseen_ = 0;         // way of the fastest particle since the tracks were advanced, m
  double travelled_ = 0;      // by the fastest particle since the maps were sampled, m
  std::size_t put_back_seen_ = 0;
  bool has_dams_;
  bool has_places_;  // zones, gauges or structures, which look at the columns
  std::vector<InflowRow> inflows_;
  std::vector<const InflowPlan*> inflow_plans_;
  Energy freed_;       // of what inflows have set free, at the time they did
  double pushed_ = 0;  // work of what pushed that, J
  Energy left_;
  std::vector<SeriesRow> rows_;
  CsvWriter front_csv_, discharge_csv_, volumes_csv_, zones_csv_, energy_csv_, rest_csv_,
      solver_csv_;
  Particles seen_;      // when the maps were last sampled, from a backend that is copied
  Background mapping_;  // the last: it ends before what it works on
};

}  // namespace sabo
