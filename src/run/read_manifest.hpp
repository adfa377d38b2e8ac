#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "io/case_file/toml_tree.hpp"

namespace sabo {

inline constexpr std::size_t largest_manifest = 50'000'000;  ///< bytes; a load takes some 300

/// The text of a manifest, from the file `name`. Throws CaseError when it is no TOML or has no
/// table [run].
TomlTable parse_manifest(std::string_view text, const std::string& name);

/// manifest.toml in the folder of a run. Throws CaseError as well when it cannot be read.
TomlTable read_manifest(const std::filesystem::path& folder);

}  // namespace sabo
