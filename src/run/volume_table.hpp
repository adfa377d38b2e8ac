#pragma once

#include <string>
#include <vector>

#include "io/output/index_page.hpp"
#include "run/recorder.hpp"

namespace sabo {

/// Volumes at each dam beside those known from elsewhere (the case's references); one table per
/// dam, one alone without a dam.
std::vector<PageTable> volume_tables(const Case& c, const Scene& scene, const SeriesRow& row);

/// The same as aligned text.
std::vector<std::string> volume_table_text(const Case& c, const Scene& scene, const SeriesRow& row);

}  // namespace sabo
