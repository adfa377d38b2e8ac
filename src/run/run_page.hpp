#pragma once

#include <vector>

#include "io/output/index_page.hpp"
#include "run/run_facts.hpp"

namespace sabo {

/// The page of the run.
IndexPage index_page(const RunFacts& facts, const Case& c, const Scene& scene,
                     const std::vector<SeriesRow>& rows, std::vector<PagePicture> pictures);

}  // namespace sabo
