#include <memory>

#include <fmt/format.h>

#include "app/commands.hpp"
#include "run/state_pictures.hpp"

namespace sabo {
namespace {

struct PlotOptions {
  std::string folder;
  std::vector<double> times;
};

}  // namespace

void add_plot_command(CLI::App& program, Action& action) {
  CLI::App* command = program.add_subcommand(
      "plot", "Draw depth, speed and pressure of a run at some times, from above and in 3D");
  const auto options = std::make_shared<PlotOptions>();
  command->add_option("DIR", options->folder, "folder of a run")->required()->type_name("");
  command
      ->add_option("--times", options->times,
                   "times, of which the nearest frames are taken; default: six over the run")
      ->delimiter(',')
      ->type_name("S,S,...");
  command->footer("Examples:\n  sabo plot demo-run\n  sabo plot demo-run --times 10,20,28,50,70");
  command->callback([&action, options] {
    action = {"", [options] {
                fmt::print("Open {}\n", draw_states(options->folder, options->times).string());
                return exit_done;
              }};
  });
}

}  // namespace sabo
