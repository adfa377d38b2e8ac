#pragma once

#include <cstdlib>
#include <filesystem>

namespace sabo {

/// The root of the repository that the tests were compiled from.
inline std::filesystem::path repository() {
  return std::filesystem::path(__FILE__).parent_path().parent_path().parent_path();
}

/// Large public data that the repository does not hold: $SABO_DATA, else the folder `shared` beside
/// the repository. It may not exist; its tests are then skipped.
inline std::filesystem::path data_folder() {
  const char* named = std::getenv("SABO_DATA");
  return named ? std::filesystem::path(named) : repository().parent_path() / "shared";
}

}  // namespace sabo
