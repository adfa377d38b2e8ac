#pragma once

#include <string>
#include <vector>

#include "io/output/index_page.hpp"
#include "run/scene.hpp"
#include "run/series_row.hpp"

namespace sabo {

/// Volumes at each dam beside those known from elsewhere (the case's references); one table per
/// dam, one alone without a dam.
std::vector<PageTable> volume_tables(const Case& c, const Scene& scene, const SeriesRow& row,
                                     const std::vector<Basin>& basins);

/// Depth in each zone beside what was observed; of a case with zones.
PageTable zone_table(const Case& c, const SeriesRow& row);

/// Every key of the material and of the method with its value and unit.
PageTable parameter_table(const Case& c);

/// A table as aligned lines of text.
std::vector<std::string> text_of(const PageTable& table);

}  // namespace sabo
