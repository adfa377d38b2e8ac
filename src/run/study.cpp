#include "run/study.hpp"

#include <system_error>

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/output/file.hpp"
#include "run/study_page.hpp"
#include "run/study_record.hpp"
#include "run/study_table.hpp"
#include "run/tables.hpp"

namespace sabo {
namespace {

namespace fs = std::filesystem;

/// Makes the folder and marks it as that of a study; throws CaseError when it holds anything else.
void prepare(const fs::path& folder) {
  std::error_code error;
  const fs::path mark = folder / "study.toml";
  if (fs::exists(folder, error)) {
    if (!fs::is_directory(folder, error))
      throw CaseError(folder.string(), "is a file, not a folder", "choose another name with -o");
    if (!fs::is_empty(folder, error) && !fs::exists(mark, error))
      throw CaseError(folder.string(), "holds files that are not those of a study",
                      "choose another folder with -o");
  }
  fs::create_directories(folder, error);
  if (error) throw RunError("cannot make " + folder.string() + ": " + error.message());
  if (!fs::exists(mark, error)) write_file_atomically(mark, "[study]\n");
}

class Study {
 public:
  Study(const std::vector<StudyRun>& runs, const StudyOptions& options)
      : runs_(runs), options_(options) {}

  StudyResult run() {
    for (std::size_t k = 0; k < runs_.size() && result_.end != RunEnd::interrupted; ++k)
      make(runs_[k], fmt::format("Run {} of {}: {}", k + 1, runs_.size(), runs_[k].folder));
    conclude();
    return result_;
  }

 private:
  void make(const StudyRun& run, const std::string& heading) {
    const fs::path folder = options_.folder / run.folder;
    if (const auto record = finished_record(folder, run.c)) {
      tell(heading + " is there already");
      return keep(run, *record);
    }
    tell(heading);
    const RunResult result = run_case(run.c, {folder, true, options_.on_progress, options_.stop});
    if (result.end == RunEnd::interrupted) result_.end = RunEnd::interrupted;
    if (result.end == RunEnd::failed) return fail(run, result.reason);
    if (result.end != RunEnd::finished) return;
    const auto record = finished_record(folder, run.c);
    if (!record) return fail(run, "its manifest cannot be read back, or its inputs have changed");
    keep(run, *record);
  }

  void keep(const StudyRun& run, StudyRecord record) {
    record.member = run.member;
    record.folder = run.folder;
    records_.push_back(std::move(record));
  }

  void fail(const StudyRun& run, const std::string& reason) {
    result_.end = RunEnd::failed;
    if (!result_.reason.empty()) result_.reason += "\n";
    result_.reason += run.folder + ": " + reason;
  }

  void conclude() {
    if (records_.empty()) return;
    const StudyTable table = study_table(records_);
    std::vector<std::string> warnings = study_warnings(records_, table);
    if (records_.size() < runs_.size())
      warnings.push_back(fmt::format(
          "{} of {} runs are missing, which {}", runs_.size() - records_.size(), runs_.size(),
          result_.end == RunEnd::interrupted ? "were not made yet" : "failed"));
    result_.index = write_study(options_.folder, runs_.front().c, records_, table, warnings);
    for (const PageTable& page : {runs_table(records_), quantities_table(table)})
      for (const std::string& line : text_of(page)) result_.summary.push_back(line);
    for (const std::string& warning : warnings) result_.summary.push_back("Warning: " + warning);
  }

  void tell(const std::string& line) const {
    if (options_.on_run) options_.on_run(line);
  }

  const std::vector<StudyRun>& runs_;
  const StudyOptions& options_;
  std::vector<StudyRecord> records_;
  StudyResult result_;
};

}  // namespace

StudyResult run_study(const StudyRequest& request, const StudyOptions& options) {
  const std::vector<StudyRun> runs = study_plan(request);
  prepare(options.folder);
  return Study(runs, options).run();
}

}  // namespace sabo
