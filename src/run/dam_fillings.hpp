#pragma once

#include <vector>

#include "analysis/basin.hpp"
#include "io/output/csv.hpp"
#include "run/run_folder.hpp"
#include "run/scene.hpp"

namespace sabo {

/// The basin behind a check dam, on the side of the release.
Basin basin_behind(const CheckDam& dam, const Scene& scene);

/// How full the basins behind the check dams of a scene are: series/filling.csv.
class DamFillings {
 public:
  DamFillings(const Scene& scene, const RunFolder& folder);

  /// A row; one entry per check dam.
  std::vector<BasinState> write_row(double time, const Columns& columns);

  /// One per check dam.
  const std::vector<Basin>& basins() const { return basins_; }

  template <class Archive>
  void archive(Archive& a) {
    a(csv_);
  }

 private:
  std::vector<Basin> basins_;
  CsvWriter csv_;
};

}  // namespace sabo
