#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"

namespace sabo {

/// A key whose values differ between two cases.
struct KeyDifference {
  std::string key;     ///< "numerics.spacing", "structure[2].height"
  std::string before;  ///< in TOML; empty where it is not given
  std::string after;
};

/// In the order of the documentation. Files count by their name without the folder: a case may have
/// been moved.
std::vector<KeyDifference> case_differences(Case before, Case after);

}  // namespace sabo
