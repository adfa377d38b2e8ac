#pragma once

#include <cstdint>
#include <vector>

#include "terrain/check_dam.hpp"
#include "terrain/ground_columns.hpp"
#include "terrain/surface.hpp"

namespace sabo {

/// Upright piece of a dam, from the ground or the upper edge of an opening upwards.
struct DamColumn {
  double x = 0;
  double y = 0;
  double bottom = 0;       ///< elevation, m
  double top = 0;          ///< elevation, m
  double area = 0;         ///< in plan, m2
  std::uint16_t body = 0;  ///< number of the dam among the bodies, from 1
};

/// Columns at most `spacing` (m) apart that fill the wall and leave its openings free, at least two
/// across. Along the line they are spaced evenly between the corners of its plan, its top and its
/// openings, so that each column stands under a straight piece of crest and the volume is exact
/// where the line is straight; in its bends the outer side is rounded, as contains() has it.
/// Places outside the surface's domain and below its ground have none. Throws CaseError when no
/// column is left, or far too many are asked.
std::vector<DamColumn> dam_columns(const CheckDam& dam, const Surface& surface, double spacing);

/// Appends the particles of a column, at most `settings.spacing` apart.
void fill_column(const DamColumn& column, const GroundSettings& settings,
                 std::vector<GroundPoint>& into);

}  // namespace sabo
