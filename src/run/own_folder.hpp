#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace sabo {

/// Whether a folder that is to be written to holds files, which must be ours: `is_ours` is asked
/// when there are any. Throws CaseError for a file and for a folder with those of others; `whose`
/// completes "holds files that are not those of ...".
bool holds_own_files(const std::filesystem::path& folder, const std::function<bool()>& is_ours,
                     const std::string& whose);

}  // namespace sabo
