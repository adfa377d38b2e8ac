#pragma once

#include "io/output/csv.hpp"
#include "run/run_folder.hpp"
#include "run/scene.hpp"
#include "run/series_row.hpp"

namespace sabo {

/// Writes rows of the series: front, discharge, volumes, zones, energy, rest and solver. (What
/// looks into the flow closer has tables of its own.)
class SeriesTables {
 public:
  SeriesTables(const Scene& scene, const RunFolder& folder);

  void append(const SeriesRow& row);

  template <class Archive>
  void archive(Archive& a) {
    a(front_, discharge_, volumes_, zones_, energy_, rest_, solver_);
  }

 private:
  bool has_dams_;
  CsvWriter front_, discharge_, volumes_, zones_, energy_, rest_, solver_;
};

}  // namespace sabo
