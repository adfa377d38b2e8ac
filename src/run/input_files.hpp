#pragma once

#include <filesystem>
#include <vector>

#include "case/case.hpp"

namespace sabo {

/// Every file that a case names, in the order of its keys, each once; of a folder all files in it,
/// sorted; beside a file those of its name that end in .dbf or .prj. Names of GDAL's virtual file
/// systems ("/vsi...") are left out.
std::vector<std::filesystem::path> input_files(Case c);

}  // namespace sabo
