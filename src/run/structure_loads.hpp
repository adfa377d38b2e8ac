#pragma once

#include <string>
#include <vector>

#include "analysis/approach.hpp"
#include "backend/model.hpp"
#include "case/load_case.hpp"
#include "io/output/csv.hpp"
#include "run/mean_load.hpp"
#include "run/run_folder.hpp"
#include "run/scene.hpp"
#include "run/series_row.hpp"

namespace sabo {

/// What a structure had to bear.
struct LoadSummary {
  std::string name;
  double peak = 0;       ///< greatest horizontal force as a mean over the filter, N
  double peak_time = 0;  ///< end of its window, s
  Vec3d impulse;         ///< of all the run, N s
  // Greatest values of the design formulas over the rows, N.
  double hydrostatic = 0;
  double dynamic = 0;
  // The row with the greatest horizontal force.
  double row_time = 0;
  Vec3d row_force;                        ///< N
  Vec3d row_moment;                       ///< about the middle of the base, N m
  std::vector<LoadProfile::Bin> profile;  ///< over the height

  template <class Archive>
  void archive(Archive& a) {
    a(name, peak, peak_time, impulse, hydrostatic, dynamic, row_time, row_force, row_moment,
      profile);
  }
};

/// Writes what the structures of a scene have to bear, series/loads.csv and
/// series/pressure_profiles.csv, beside what comes of the flow before them by design formulas.
class StructureLoads {
 public:
  StructureLoads(const LoadCase& settings, const Scene& scene, const FlowModel& model,
                 const RunFolder& folder);

  bool is_empty() const { return summaries_.empty(); }

  /// A row of each file. One entry per structure.
  std::vector<LoadRow> write_row(double time, const std::vector<MeanLoad>& means,
                                 const Columns& columns);

  /// One entry per structure.
  const std::vector<LoadSummary>& summaries() const { return summaries_; }

  template <class Archive>
  void archive(Archive& a) {
    a.fixed(summaries_);
    a(loads_csv_, profiles_csv_);
  }

 private:
  LoadRow write_structure(std::size_t number, double time, const MeanLoad& mean,
                          const Columns& columns, std::vector<double>& row);

  LoadCase settings_;
  double density_, gravity_;
  std::vector<Approach> approaches_;
  std::vector<LoadSummary> summaries_;
  CsvWriter loads_csv_;
  CsvWriter profiles_csv_;
};

}  // namespace sabo
