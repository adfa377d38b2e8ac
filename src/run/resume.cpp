#include "run/resume.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "io/case_file/read_case.hpp"
#include "io/output/checksum.hpp"
#include "run/case_difference.hpp"
#include "run/input_files.hpp"
#include "run/read_manifest.hpp"

namespace sabo {
namespace {

namespace fs = std::filesystem;

constexpr std::array free_keys{"title",
                               "note",
                               "numerics.threads",
                               "run.duration",
                               "run.checkpoint_interval",
                               "run.kept_checkpoint_interval",
                               "run.stop_at_rest"};

/// How the run ended by its manifest; "" if that cannot be read.
std::string end_of(const fs::path& run_folder) {
  try {
    return text_at(table_at(read_manifest(run_folder), "run"), "end").value_or("");
  } catch (const CaseError&) {
    return "";
  }
}

void check_same_case(const Case& c, const FoundCheckpoint& checkpoint) {
  Faults faults;
  for (const KeyDifference& difference : case_differences(case_of(checkpoint), c)) {
    if (std::ranges::find(free_keys, difference.key) != free_keys.end()) continue;
    faults.add(difference.key,
               fmt::format("is {} and was {} in the run that is to go on",
                           difference.after.empty() ? "not given" : difference.after,
                           difference.before.empty() ? "not given" : difference.before),
               "set it back; --branch-at starts a changed case from a state of this one");
  }
  faults.throw_if_any();
  const std::vector<fs::path> files = input_files(c);
  const std::vector<std::string>& before = checkpoint.head.inputs;
  for (std::size_t k = 0; k < std::max(files.size(), before.size()); ++k) {
    if (k >= files.size())
      faults.add("", "an input file of the run that is to go on is gone", "put it back");
    else if (k >= before.size() || checksum(files[k]) != before[k])
      faults.add(files[k].string(), "has changed since the run began",
                 "put the former file back; --branch-at starts a changed case from a state of this "
                 "one");
  }
  faults.throw_if_any();
}

}  // namespace

Case case_of(const FoundCheckpoint& checkpoint) {
  Faults faults;
  Case c = read_former_case(checkpoint.head.case_text, checkpoint.file.parent_path(), faults);
  if (!faults.empty())
    throw RunError(checkpoint.file.string() +
                   " was written by another version, whose case this one cannot read: " +
                   to_string(faults.list().front()));
  return c;
}

std::vector<FoundCheckpoint> checkpoints_to_resume(
    const Case& c, const fs::path& run_folder,
    const std::function<void(const std::string&)>& tell) {
  std::error_code error;
  if (!fs::exists(run_folder / "manifest.toml", error))
    throw CaseError(run_folder.string(), "holds no run that could go on",
                    "run it without --resume");
  std::string damaged;
  std::vector<FoundCheckpoint> found =
      find_checkpoints(run_folder / "checkpoint", [&](const std::string& line) {
        tell("warning: " + line);
        damaged = line;
      });
  if (found.empty())
    throw CaseError(run_folder.string(),
                    damaged.empty() ? "has no checkpoint: what it had computed is lost"
                                    : "has no checkpoint that can be read (" + damaged +
                                          "): what it had computed is lost",
                    "start anew with --overwrite");
  check_same_case(c, found.front());
  if (end_of(run_folder) == "finished" && found.front().head.time >= c.run.duration)
    throw CaseError(run_folder.string(),
                    fmt::format("has finished, at {:g} s", found.front().head.time),
                    "give a longer --duration to let it go on");
  return found;
}

}  // namespace sabo
