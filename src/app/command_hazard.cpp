#include <memory>

#include "post/hazard.hpp"
#include <fmt/format.h>

#include "app/commands.hpp"

namespace sabo {
namespace {

int hazard(const HazardOptions& options) {
  if (options.runs.empty()) {
    fmt::print("{}", hazard_rules_of(options.rules));
    return exit_done;
  }
  const PostResult result = hazard_maps(options);
  for (const std::string& line : result.summary) fmt::print("{}\n", line);
  fmt::print("Open {}\n", result.index.string());
  return exit_done;
}

}  // namespace

void add_hazard_command(CLI::App& program, Action& action) {
  CLI::App* command = program.add_subcommand(
      "hazard", "Classify the maps of runs by rules; without a run, print the rules");
  const auto options = std::make_shared<HazardOptions>();
  command
      ->add_option("RUN", options->runs,
                   "folders of runs; of several the worst class of each cell counts")
      ->type_name("");
  command
      ->add_option("--rules", options->rules,
                   "swiss, austria, japan, or a file of rules; default: swiss")
      ->type_name("RULES");
  command
      ->add_option("--periods", options->return_periods,
                   "return period of each run, years: adds the level of hazard by the matrix of "
                   "the rules")
      ->delimiter(',')
      ->allow_extra_args(false)  // which may be runs
      ->type_name("Y,Y,...");
  command
      ->add_option("-o,--output", options->output,
                   "folder of the result; default: hazard in the first run")
      ->type_name("DIR");
  command->footer(
      "What rules may look at, greatest values of a cell over the run but for deposit, the depth\n"
      "at its end:\n  depth [m], deposit [m], speed [m/s], depth_speed [m2/s], energy_head [m],\n"
      "  momentum_flux [kN/m], pressure [kPa], impact = density x speed2 [kPa],\n"
      "  impact_over_house = impact over the strength of a house, a / (H (b - H))\n\n"
      "Examples:\n  sabo hazard demo-run --rules japan\n"
      "  sabo hazard run-30 run-100 run-300 --rules swiss --periods 30,100,300\n"
      "  sabo hazard --rules swiss > my.toml\n\n"
      "Classes are no hazard map by law: read the caution in the rules.");
  command->callback([&action, options] { action = {"", [options] { return hazard(*options); }}; });
}

}  // namespace sabo
