#include <memory>

#include "app/batch_display.hpp"
#include "app/case_option.hpp"
#include "app/commands.hpp"
#include "run/load_case.hpp"
#include "run/study.hpp"

namespace sabo {
namespace {

struct StudyCommandOptions {
  StudyRequest request;
  std::string folder;
};

int study(const StudyCommandOptions& options) {
  const std::string folder =
      options.folder.empty() ? name_of_case(options.request.case_path) + "-study" : options.folder;
  return show_batch(folder,
                    [&](const BatchOptions& batch) { return run_study(options.request, batch); });
}

}  // namespace

void add_study_command(CLI::App& program, Action& action) {
  CLI::App* command = program.add_subcommand(
      "study", "Run a case at several spacings and say how results depend on the spacing");
  const auto options = std::make_shared<StudyCommandOptions>();
  StudyRequest& request = options->request;
  command
      ->add_option("CASE", request.case_path,
                   "case file, folder with a case.toml, or AvaFrame project")
      ->required()
      ->type_name("");
  command
      ->add_option("--spacings", request.spacings,
                   "particle spacings, m; three with ratios of 1.3 or more show an order")
      ->required()
      ->delimiter(',')
      ->type_name("M,M,...");
  command
      ->add_option("-o,--output", options->folder,
                   "folder of the study, which finds its finished runs again; default: name of the "
                   "case's folder with -study")
      ->type_name("DIR");
  command
      ->add_option("--members", request.members,
                   "runs at each spacing with jittered starts: the scatter of the results")
      ->type_name("N");
  add_case_option(*command, "release", "jitter", request.overrides);
  add_run_options(*command, request.overrides);
  command->footer(
      "Examples:\n  sabo study demo --spacings 4,3,2.2\n"
      "  sabo study demo --spacings 4,3,2.2 --members 5 --duration 60");
  command->callback([&action, options] {
    action = {options->request.case_path.string(), [=] { return study(*options); }};
  });
}

}  // namespace sabo
