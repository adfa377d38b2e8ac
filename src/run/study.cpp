#include "run/study.hpp"

#include "run/study_page.hpp"
#include "run/study_table.hpp"
#include "run/tables.hpp"

namespace sabo {

BatchResult run_study(const StudyRequest& request, const BatchOptions& options) {
  const std::vector<StudyRun> plan = study_plan(request);
  prepare_batch(options.folder, "study");
  std::vector<BatchRun> runs;
  for (const StudyRun& run : plan) runs.push_back({run.folder, run.c});

  BatchResult result;
  const auto made = make_runs(runs, options, result);
  std::vector<BatchRecord> records;
  for (std::size_t k = 0; k < plan.size(); ++k) {
    if (!made[k]) continue;
    records.push_back(*made[k]);
    records.back().member = plan[k].member;
  }
  if (records.empty()) return result;

  const StudyTable table = study_table(records);
  std::vector<std::string> warnings = study_warnings(records, table);
  if (std::string missing = missing_runs_text(made, result); !missing.empty())
    warnings.push_back(std::move(missing));
  result.index = write_study(options.folder, plan.front().c, records, table, warnings);
  for (const PageTable& page : {runs_table(records), quantities_table(table)})
    for (const std::string& line : text_of(page)) result.summary.push_back(line);
  for (const std::string& warning : warnings) result.summary.push_back("Warning: " + warning);
  return result;
}

}  // namespace sabo
