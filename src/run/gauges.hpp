#pragma once

#include "analysis/columns.hpp"
#include "backend/model.hpp"
#include "io/output/csv.hpp"
#include "run/run_folder.hpp"
#include "run/scene.hpp"

namespace sabo {

/// Depth, surface, speed and pressure at the gauges of a scene: series/gauges.csv.
class Gauges {
 public:
  Gauges(const Scene& scene, const FlowModel& model, const RunFolder& folder);

  /// Depth and speed are those of the cell of the map, pressure is that at the gauge's own point.
  void write_row(double time, const Particles& fluid, const Columns& columns);

  template <class Archive>
  void archive(Archive& a) {
    a(csv_);
  }

 private:
  const Scene& scene_;
  FlowModel model_;
  CsvWriter csv_;
};

}  // namespace sabo
