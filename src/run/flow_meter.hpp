#pragma once

#include <optional>
#include <vector>

#include "analysis/columns.hpp"
#include "analysis/flow_maps.hpp"
#include "analysis/front.hpp"
#include "analysis/rest.hpp"
#include "analysis/zone.hpp"
#include "case/case.hpp"
#include "run/dam_fillings.hpp"
#include "run/gauges.hpp"
#include "run/run_folder.hpp"
#include "run/scene.hpp"
#include "run/section_states.hpp"
#include "run/series_row.hpp"
#include "run/series_tables.hpp"
#include "run/structure_loads.hpp"

namespace sabo {

/// What goes into a row beside what the particles show.
struct RowStart {
  SeriesRow row;                ///< what is known of it; of `entered` what inflows have set free
  double pushed = 0;            ///< work of what pushed that, J
  Tait state;                   ///< to which the densities of the fluid belong
  std::vector<MeanLoad> loads;  ///< one entry per structure
};

/// Measures a flow by its particles: maps, rows of the series and whether it rests. Nothing here
/// knows of the steps, which may go on meanwhile.
class FlowMeter {
 public:
  FlowMeter(const Case& c, const Scene& scene, const FlowModel& model, const RunFolder& folder);

  /// Appends a row to every series and returns it. Throws RunError, before it does, when the flow
  /// has more energy than it can have.
  SeriesRow write_row(const RowStart& start, const Particles& fluid);

  RestWatch& rest() { return rest_; }
  FlowMaps& maps() { return maps_; }
  const FlowMaps& maps() const { return maps_; }
  const std::vector<Basin>& basins() const { return fillings_.basins(); }
  const std::vector<LoadSummary>& loads() const { return loads_.summaries(); }

  Energy energy_in(const Particles& fluid, const Tait& state) const;

  template <class Archive>
  void archive(Archive& a) {
    a(section_states_, gauges_, fillings_, loads_, front_, rest_, maps_, first_energy_, tables_);
  }

 private:
  void check_energy(const SeriesRow& row) const;

  FlowModel model_;
  std::vector<Zone> zones_;
  Columns columns_;  // of the rows: those of the maps are sampled at other times
  SectionStates section_states_;
  Gauges gauges_;
  DamFillings fillings_;
  StructureLoads loads_;
  Front front_;
  RestWatch rest_;
  FlowMaps maps_;
  bool has_places_;                     // zones, gauges or structures, which look at the columns
  std::optional<Energy> first_energy_;  // of the first row
  SeriesTables tables_;
};

}  // namespace sabo
