#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "io/case_file/read_case.hpp"

namespace sabo {

/// A key of the case and the values that it takes.
struct Variation {
  Override key;  ///< its value is of no account
  std::vector<Override::Value> values;

  std::string name() const { return key.table + "." + key.key; }
};

/// Reads "material.friction_angle=25,30", "structure[1].height=4:8:2" (from 4 to 8 in steps of 2)
/// or "numerics.wall=no_slip,coulomb". Throws CaseError at "--vary".
Variation read_variation(const std::string& text);

/// A value as it stands in the case and in names of folders.
std::string value_text(const Override::Value& value);

struct SweepRequest {
  std::filesystem::path case_path;
  std::vector<Variation> variations;
  std::vector<Override> overrides;  ///< the same for all runs
  std::vector<double> depths;       ///< of the exceedance maps, m
};

/// One run of a sweep.
struct SweepRun {
  std::vector<std::string> values;  ///< one per variation
  std::string folder;               ///< below that of the sweep
  Case c;
};

/// Each combination of values, the last variation changing fastest. Reads the case and all it names
/// for each: throws CaseError with what is wrong with the request or with a case.
std::vector<SweepRun> sweep_plan(const SweepRequest& request);

}  // namespace sabo
