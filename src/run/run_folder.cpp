#include "run/run_folder.hpp"

#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/case_file/toml_string.hpp"
#include "io/output/file.hpp"
#include "run/own_folder.hpp"

namespace sabo {

namespace fs = std::filesystem;

namespace {

/// A fault of the call: the user can name another folder.
void make_or_refuse(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw CaseError(folder.string(), "cannot be made: " + error.message(),
                    "choose another folder with -o");
}

}  // namespace

RunFolder::RunFolder(std::filesystem::path folder, FormerRun former)
    : root_(std::move(folder)), goes_on_(former == FormerRun::resumed) {
  std::error_code error;
  if (goes_on_ && !fs::exists(manifest(), error))
    throw CaseError(root_.string(), "holds no run that could go on", "run it without --resume");
  const auto refuse_former = [&] {
    if (holds_run() && former == FormerRun::kept)
      throw CaseError(
          root_.string(), "holds a run already",
          "choose another folder with -o, let it go on with --resume, or say --overwrite");
  };
  refuse_former();
  make_or_refuse(root_);
  lock_.emplace(root_);
  refuse_former();  // another process may have made one until now
  remove_made_of_results();
  if (former == FormerRun::replaced) remove_results();
  for (const fs::path& part : {maps(), series(), frames(), pictures(), checkpoints()})
    make_or_refuse(part);
  remove_parts();
  // From here on the folder is known as that of a run, whatever happens to it.
  set_state("running", "");
}

/// Whether there is a run, whatever came of it. Throws CaseError for the files of others.
bool RunFolder::holds_run() const {
  std::error_code error;
  const auto is_ours = [&] {
    return fs::exists(manifest(), error) || fs::exists(root_ / FolderLock::file_name, error);
  };
  return holds_own_files(root_, is_ours, "a run") && fs::exists(manifest(), error);
}

/// What other commands have made of the results that are about to change.
void RunFolder::remove_made_of_results() const {
  std::error_code error;
  for (const fs::path& part : {states(), report(), japanese_report()}) fs::remove_all(part, error);
  for (const char* made : {"compare", "observed", "hazard", "export"})
    if (fs::exists(root_ / made / "result.toml", error)) fs::remove_all(root_ / made, error);
}

void RunFolder::remove_results() const {
  std::error_code error;
  for (const fs::path& part :
       {maps(), series(), frames(), pictures(), view(), index(), checkpoints()})
    fs::remove_all(part, error);
}

/// Of files that a killed process was writing, see PartialFile.
void RunFolder::remove_parts() const {
  std::error_code error;
  for (const fs::path& folder :
       {root_, maps(), series(), frames(), pictures(), checkpoints(), view()})
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
      if (entry.path().stem().extension() == ".part") fs::remove(entry.path(), error);
}

void RunFolder::set_state(const std::string& end, const std::string& reason) const {
  write_file_atomically(manifest(), fmt::format("[run]\nend = {}\nreason = {}\n", toml_string(end),
                                                toml_string(reason)));
}

}  // namespace sabo
