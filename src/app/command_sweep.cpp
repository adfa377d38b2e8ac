#include <memory>

#include "app/batch_display.hpp"
#include "app/case_option.hpp"
#include "app/commands.hpp"
#include "run/load_case.hpp"
#include "run/sweep.hpp"

namespace sabo {
namespace {

struct SweepCommandOptions {
  SweepRequest request{{}, {}, {}, {0.1, 0.5, 1, 2}};
  std::vector<std::string> variations;
  std::string folder;
};

int sweep(const SweepCommandOptions& options) {
  SweepRequest request = options.request;
  for (const std::string& text : options.variations)
    request.variations.push_back(read_variation(text));
  const std::string folder =
      options.folder.empty() ? name_of_case(request.case_path) + "-sweep" : options.folder;
  return show_batch(folder, [&](const BatchOptions& batch) { return run_sweep(request, batch); });
}

}  // namespace

void add_sweep_command(CLI::App& program, Action& action) {
  CLI::App* command = program.add_subcommand(
      "sweep", "Run a case over values of its keys: a table of the results, exceedance maps");
  const auto options = std::make_shared<SweepCommandOptions>();
  command
      ->add_option("CASE", options->request.case_path,
                   "case file, folder with a case.toml, or AvaFrame project")
      ->required()
      ->type_name("");
  command
      ->add_option("--vary", options->variations,
                   "a key and its values, KEY=V,V,... or KEY=FIRST:LAST:STEP; several: each "
                   "combination is a run")
      ->required()
      ->type_name("KEY=VALUES");
  command
      ->add_option("--depths", options->request.depths,
                   "depths of the exceedance maps, m; default: 0.1,0.5,1,2")
      ->delimiter(',')
      ->type_name("M,M,...");
  command
      ->add_option("-o,--output", options->folder,
                   "folder of the sweep, which finds its finished runs again; default: name of the "
                   "case's folder with -sweep")
      ->type_name("DIR");
  std::vector<Override>& overrides = options->request.overrides;
  add_case_option(*command, "numerics", "spacing", overrides);
  add_run_options(*command, overrides);
  command->footer(
      "Examples:\n  sabo sweep demo --vary material.pore_pressure_ratio=0:0.6:0.2\n"
      "  sabo sweep demo --vary release.volume=5000,9000 --vary structure[1].height=6:10:2");
  command->callback([&action, options] {
    action = {options->request.case_path.string(), [=] { return sweep(*options); }};
  });
}

}  // namespace sabo
