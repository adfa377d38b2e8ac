#pragma once

#include <vector>

#include "analysis/section_state.hpp"
#include "backend/model.hpp"
#include "io/output/csv.hpp"
#include "run/run_folder.hpp"
#include "run/scene.hpp"

namespace sabo {

/// Area, depth and speeds at the sections of a scene, series/sections.csv, and their speed over the
/// height, series/velocity_profiles.csv.
class SectionStates {
 public:
  SectionStates(const Scene& scene, const FlowModel& model, const RunFolder& folder);

  void write_row(double time, const Particles& fluid);

  template <class Archive>
  void archive(Archive& a) {
    a(sections_csv_, profiles_csv_);
  }

 private:
  const Scene& scene_;
  std::vector<SectionSlab> slabs_;
  CsvWriter sections_csv_, profiles_csv_;
};

}  // namespace sabo
