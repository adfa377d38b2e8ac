#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "app/case_option.hpp"
#include "app/commands.hpp"
#include "app/messages.hpp"
#include "app/progress_display.hpp"
#include "app/stop_signals.hpp"
#include "base/error.hpp"
#include "base/shell_word.hpp"
#include "run/load_case.hpp"
#include "run/simulation.hpp"

namespace sabo {
namespace {

struct RunCommandOptions {
  std::string case_path;
  std::string folder;
  bool overwrite = false;
  bool resume = false;
  std::optional<double> branch_at;  // s
  std::string branch_from;
  std::vector<Override> overrides;
};

void print_heading(const Case& c, const std::filesystem::path& folder) {
  if (!c.title.empty()) fmt::print("{}\n", c.title);
  if (!c.note.empty()) fmt::print("{}\n", c.note);
  fmt::print("Results go to {}\n", folder.string());
  std::fflush(stdout);
}

int report(const RunResult& result, const std::filesystem::path& folder, bool has_checkpoint) {
  for (const std::string& line : result.summary) fmt::print("{}\n", line);
  if (!result.index.empty())
    fmt::print("Open {}\nFor a report: sabo report {}\n", result.index.string(),
               shell_word(result.index.parent_path().string()));
  std::fflush(stdout);
  switch (result.end) {
    case RunEnd::finished:
      return exit_done;
    case RunEnd::interrupted:
      if (has_checkpoint)
        fmt::print("To go on: sabo run {} --resume\n", shell_word(folder.string()));
      std::fflush(stdout);
      return exit_stopped;
    case RunEnd::failed:
      break;
  }
  print_error(result.reason);
  return exit_run_failed;
}

/// A run that goes on may be named by its folder alone.
std::filesystem::path folder_of(const RunCommandOptions& options) {
  std::error_code error;
  const std::filesystem::path path = options.case_path;
  if (!options.folder.empty()) return options.folder;
  if (options.resume && std::filesystem::exists(path / "manifest.toml", error)) return path;
  return name_of_case(path) + "-run";
}

int run(const RunCommandOptions& options) {
  const std::atomic<bool>& stop = catch_stop_signals();
  Faults faults;
  const Case c = load_case(options.case_path, faults, options.overrides);
  faults.throw_if_any();

  RunOptions run_options;
  run_options.folder = folder_of(options);
  if (options.overwrite) run_options.former = FormerRun::replaced;
  if (options.resume) run_options.former = FormerRun::resumed;
  if (options.branch_at && !(*options.branch_at >= 0 && std::isfinite(*options.branch_at)))
    throw CaseError("--branch-at", "is not a time", "give seconds since the start of that run");
  std::error_code error;
  if (options.branch_at &&
      std::filesystem::equivalent(options.branch_from, run_options.folder, error))
    throw CaseError("--output", "is the run that this one starts from", "give another folder");
  if (options.branch_at) run_options.branch = {options.branch_from, *options.branch_at};
  run_options.stop = &stop;
  ProgressDisplay display(std::ranges::any_of(c.structures, [](const StructureCase& structure) {
    return structure.kind == StructureKind::check_dam;
  }));
  run_options.on_progress = [&](const RunProgress& progress) { display.show(progress); };
  run_options.on_note = [&](const std::string& line) {
    display.finish();
    fmt::print("{}\n", line);
  };

  print_heading(c, run_options.folder);
  const RunResult result = run_case(c, run_options);
  display.finish();
  return report(result, run_options.folder, c.run.checkpoint_interval > 0);
}

}  // namespace

void add_run_command(CLI::App& program, Action& action) {
  CLI::App* command = program.add_subcommand("run", "Run a case");
  const auto options = std::make_shared<RunCommandOptions>();
  command
      ->add_option("CASE", options->case_path,
                   "case file, folder with a case.toml, or AvaFrame project")
      ->required()
      ->type_name("");
  command
      ->add_option("-o,--output", options->folder,
                   "folder of the results; default: name of the case's folder with -run")
      ->type_name("DIR");
  command->add_flag("--overwrite", options->overwrite,
                    "replace the results of a former run in that folder");
  command
      ->add_flag("--resume", options->resume,
                 "go on with the run in that folder from its last checkpoint; CASE may be the "
                 "folder itself")
      ->excludes("--overwrite");
  auto* branch_at = command->add_option("--branch-at", options->branch_at,
                                        "start with the flow as it was in another run at this "
                                        "time, s: a dam may be added meanwhile");
  auto* from = command->add_option("--from", options->branch_from, "folder of that run");
  branch_at->type_name("TIME")->needs(from)->excludes("--resume");
  from->type_name("RUN")->needs(branch_at);
  add_case_option(*command, "numerics", "spacing", options->overrides);
  add_run_options(*command, options->overrides);
  command->footer(
      "Examples:\n  sabo run demo\n  sabo run demo -o coarse --spacing 1.5 --duration 60\n"
      "  sabo run demo-run --resume\n"
      "  sabo run with-dam --branch-at 60 --from demo-run");
  command->callback([&action, options] {
    action = {options->case_path, [=] { return run(*options); }};
  });
}

}  // namespace sabo
