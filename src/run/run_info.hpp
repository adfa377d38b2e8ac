#pragma once

#include <filesystem>
#include <string>

#include "io/case_file/toml_tree.hpp"

namespace sabo {

/// What a manifest says, for people.
std::string manifest_text(const TomlTable& manifest);

/// What the manifest of a run folder says, for people, with the sizes of the main files. Throws
/// CaseError if `folder` is not the folder of a run.
std::string run_info_text(const std::filesystem::path& folder);

}  // namespace sabo
