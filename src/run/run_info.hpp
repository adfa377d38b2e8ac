#pragma once

#include <filesystem>
#include <string>

namespace sabo {

/// What the manifest of a run folder says, for people, with the sizes of the main files. Throws
/// CaseError if `folder` is not the folder of a run.
std::string run_info_text(const std::filesystem::path& folder);

}  // namespace sabo
