#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace sabo {

/// A case made from other software's input.
struct MadeCase {
  std::string text;              ///< of a case file
  std::filesystem::path folder;  ///< where its relative paths start
};

/// The case of an AvaFrame project (the folder with REL/ and a DEM, or the one above, with
/// Inputs/): DEM, the first release file with its attribute `thickness` (normal to the ground), dam
/// line, path. AvaFrame gives no material and no particle spacing: what is assumed stands in the
/// text. Entrainment (ENT) and resistance (RES) are not modelled. Nothing when the folder has a
/// case.toml or does not look like such a project. Throws CaseError when it does and lacks a DEM.
std::optional<MadeCase> avaframe_case(const std::filesystem::path& folder);

}  // namespace sabo
