#pragma once

#include <string>
#include <vector>

#include "analysis/approach.hpp"
#include "analysis/load_peak.hpp"
#include "analysis/load_profile.hpp"
#include "backend/backend.hpp"
#include "case/load_case.hpp"
#include "io/output/csv.hpp"
#include "run/run_folder.hpp"
#include "run/scene.hpp"
#include "solver/stepper.hpp"

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

/// One row of a structure, for the pictures.
struct LoadRow {
  double force = 0;                     ///< horizontal, N
  double hydrostatic = 0, dynamic = 0;  ///< by the design formulas, N
};

/// Measures the forces on the dams and bodies of a scene and writes series/loads.csv and
/// series/pressure_profiles.csv.
class StructureLoads {
 public:
  StructureLoads(const LoadCase& settings, const Scene& scene, const FlowModel& model,
                 const RunFolder& folder);
  ~StructureLoads();

  bool is_empty() const { return structures_.empty(); }

  /// After every step.
  void after_step(const Stepper& stepper, const StepReport& report, Backend& backend);

  /// A row of each file: means since the last one. One entry per structure.
  std::vector<LoadRow> write_row(double time, const Stepper& stepper, Backend& backend,
                                 const Columns& columns);

  std::vector<LoadSummary> summaries() const;

  template <class Archive>
  void archive(Archive& a);

 private:
  struct Structure;

  LoadRow write_structure(Structure& structure, double time, const BodyLoad& total,
                          const Columns& columns, std::vector<double>& row);

  LoadCase settings_;
  double density_, gravity_, spacing_;
  double last_row_ = 0;  // s
  std::vector<Structure> structures_;
  CsvWriter loads_csv_;
  CsvWriter profiles_csv_;
};

}  // namespace sabo
