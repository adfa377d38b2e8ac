#include "run/run_folder.hpp"

#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/case_file/toml_string.hpp"
#include "io/output/file.hpp"
#include "run/own_folder.hpp"

namespace sabo {

RunFolder::RunFolder(std::filesystem::path folder, bool overwrite) : root_(std::move(folder)) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (holds_own_files(
          root_, [&] { return fs::exists(manifest(), error); }, "a run")) {
    if (!overwrite)
      throw CaseError(root_.string(), "holds a run already",
                      "choose another folder with -o, or say --overwrite");
    for (const fs::path& part : {maps(), series(), frames(), pictures(), view(), index(), states(),
                                 report(), japanese_report()})
      fs::remove_all(part, error);
    for (const char* made : {"compare", "observed", "hazard", "export"})  // of the run before
      if (fs::exists(root_ / made / "result.toml", error)) fs::remove_all(root_ / made, error);
  }
  for (const fs::path& part : {root_, maps(), series(), frames(), pictures()}) {
    fs::create_directories(part, error);
    if (error)
      throw CaseError(part.string(), "cannot be made: " + error.message(),
                      "choose another folder with -o");
  }
  // From here on the folder is known as that of a run, whatever happens to it.
  set_state("running", "");
}

void RunFolder::set_state(const std::string& end, const std::string& reason) const {
  write_file_atomically(manifest(), fmt::format("[run]\nend = {}\nreason = {}\n", toml_string(end),
                                                toml_string(reason)));
}

}  // namespace sabo
