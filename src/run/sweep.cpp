#include "run/sweep.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "run/exceedance.hpp"
#include "run/sweep_page.hpp"
#include "run/tables.hpp"

namespace sabo {

BatchResult run_sweep(const SweepRequest& request, const BatchOptions& options) {
  const std::vector<SweepRun> plan = sweep_plan(request);
  prepare_batch(options.folder, "sweep");
  std::vector<BatchRun> runs;
  for (const SweepRun& run : plan) runs.push_back({run.folder, run.c});

  BatchResult result;
  const auto records = make_runs(runs, options, result);
  SweepTable table;
  for (const Variation& variation : request.variations) table.keys.push_back(variation.name());
  for (std::size_t k = 0; k < plan.size(); ++k)
    if (records[k]) table.rows.push_back({plan[k].values, *records[k]});
  if (table.rows.empty()) return result;

  SweepPage page{plan.front().c, table, {}, missing_runs_text(records, result)};
  std::vector<std::filesystem::path> folders;
  for (const SweepRow& row : table.rows) folders.push_back(options.folder / row.record.folder);
  try {
    page.pictures = write_exceedance(folders, request.depths, plan.front().c, options.folder);
  } catch (const RunError& error) {  // the table of what came out is worth having without maps
    if (!page.warning.empty()) page.warning += "; ";
    page.warning += fmt::format("no maps of exceedance: {}", error.what());
  }
  result.index = write_sweep(page, options.folder);
  for (const std::string& line : text_of(sweep_table(table))) result.summary.push_back(line);
  if (!page.warning.empty()) result.summary.push_back("Warning: " + page.warning);
  return result;
}

}  // namespace sabo
