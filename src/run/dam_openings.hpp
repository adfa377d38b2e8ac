#pragma once

#include <string>
#include <vector>

#include "case/structure_case.hpp"
#include "terrain/check_dam.hpp"
#include "terrain/surface.hpp"

namespace sabo {

/// Gaps and posts that a stretch of grid holds.
struct GridLayout {
  double first = 0;  ///< station at which the first gap begins, m
  int gaps = 0;      ///< with one post fewer between them
  double pitch = 0;  ///< from one gap to the next, m

  double from(int gap) const { return first + gap * pitch; }
};

/// As many gaps as fit, in the middle of the stretch.
GridLayout grid_layout(const GridCase& grid);

/// The openings of a dam that has its line and crest. `key` is that of the structure. Throws
/// CaseError for one beyond the ends of the line or not below the crest.
std::vector<Opening> dam_openings(const StructureCase& c, const CheckDam& dam,
                                  const Surface& surface, const std::string& key);

}  // namespace sabo
