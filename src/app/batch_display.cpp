#include "app/batch_display.hpp"

#include <cstdio>
#include <optional>

#include <fmt/format.h>

#include "app/exit_code.hpp"
#include "app/messages.hpp"
#include "app/progress_display.hpp"
#include "app/stop_signals.hpp"

namespace sabo {
namespace {

int report(const BatchResult& result) {
  for (const std::string& line : result.summary) fmt::print("{}\n", line);
  if (!result.index.empty()) fmt::print("Open {}\n", result.index.string());
  std::fflush(stdout);
  if (!result.reason.empty()) print_error(result.reason);
  if (result.end == RunEnd::interrupted) return exit_stopped;
  return result.end == RunEnd::finished ? exit_done : exit_run_failed;
}

}  // namespace

int show_batch(const std::string& folder,
               const std::function<BatchResult(const BatchOptions&)>& batch) {
  BatchOptions options;
  options.folder = folder;
  options.stop = &catch_stop_signals();
  std::optional<ProgressDisplay> display;
  options.on_run = [&](const std::string& line) {
    if (display) display->finish();
    display.emplace(false);
    fmt::print("{}\n", line);
    std::fflush(stdout);
  };
  options.on_progress = [&](const RunProgress& progress) { display->show(progress); };
  const BatchResult result = batch(options);
  if (display) display->finish();
  return report(result);
}

}  // namespace sabo
