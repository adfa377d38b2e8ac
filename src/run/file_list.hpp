#pragma once

#include <vector>

#include "io/output/index_page.hpp"
#include "run/scene.hpp"

namespace sabo {

/// The files that a run of the case leaves, for its page.
std::vector<PageFile> files_of_run(const Case& c, const Scene& scene);

}  // namespace sabo
