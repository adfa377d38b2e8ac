#include "run/own_folder.hpp"

#include <system_error>

#include "base/error.hpp"

namespace sabo {

bool holds_own_files(const std::filesystem::path& folder, const std::function<bool()>& is_ours,
                     const std::string& whose) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (!fs::exists(folder, error)) return false;
  if (!fs::is_directory(folder, error))
    throw CaseError(folder.string(), "is a file, not a folder", "choose another name with -o");
  if (fs::is_empty(folder, error)) return false;
  if (!is_ours())
    throw CaseError(folder.string(), "holds files that are not those of " + whose,
                    "choose another folder with -o");
  return true;
}

}  // namespace sabo
