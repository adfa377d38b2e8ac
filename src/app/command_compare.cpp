#include <memory>
#include <optional>

#include "post/compare_observed.hpp"
#include "post/compare_runs.hpp"
#include <fmt/format.h>

#include "app/commands.hpp"
#include "base/error.hpp"

namespace sabo {
namespace {

struct CompareOptions {
  std::filesystem::path first;
  std::filesystem::path second;
  std::filesystem::path output;
  ObservedOptions observed;
};

bool names_observation(const ObservedOptions& options) {
  return !options.file.empty() || options.wet_depth || !options.map.empty();
}

int compare(const CompareOptions& options) {
  if (!options.second.empty() && names_observation(options.observed))
    throw CaseError("RUN_B", "a run is compared with a run or with a survey",
                    "leave out RUN_B, or --observed with --map and --wet");
  const PostResult result = options.second.empty()
                                ? compare_observed(options.first, options.observed, options.output)
                                : compare_runs(options.first, options.second, options.output);
  for (const std::string& line : result.summary) fmt::print("{}\n", line);
  fmt::print("Open {}\n", result.index.string());
  return exit_done;
}

}  // namespace

void add_compare_command(CLI::App& program, Action& action) {
  CLI::App* command = program.add_subcommand(
      "compare", "Set a run beside another one, or beside what a survey found");
  const auto options = std::make_shared<CompareOptions>();
  command->add_option("RUN_A", options->first, "folder of a run")->required()->type_name("");
  command
      ->add_option("RUN_B", options->second,
                   "folder of a run; without it, RUN_A is compared with a survey")
      ->type_name("");
  command
      ->add_option("--observed", options->observed.file,
                   "raster of depths, or polygons of the area that was reached; default: "
                   "[observed] of the run's case")
      ->type_name("FILE");
  command
      ->add_option("--map", options->observed.map,
                   "map of the run that is set beside the survey: deposit or peak_depth; default: "
                   "the deposit with a raster, the greatest depth with polygons")
      ->type_name("MAP");
  command
      ->add_option("--wet", options->observed.wet_depth,
                   "depth above which a cell counts as reached, in the run and in a raster; "
                   "default: observed.wet_depth of the case (0.1)")
      ->type_name("M");
  command
      ->add_option("-o,--output", options->output,
                   "folder of the result; default: compare, or with a survey observed, in RUN_A")
      ->type_name("DIR");
  command->footer(
      "Examples:\n  sabo compare without-dam with-dam\n"
      "  sabo compare demo-run --observed deposit.tif --wet 0.2");
  command->callback([&action, options] { action = {"", [options] { return compare(*options); }}; });
}

}  // namespace sabo
