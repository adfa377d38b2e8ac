#include <memory>

#include <fmt/format.h>

#include "app/commands.hpp"
#include "run/run_info.hpp"

namespace sabo {

void add_info_command(CLI::App& program, Action& action) {
  CLI::App* command = program.add_subcommand("info", "Say what a run folder holds");
  const auto folder = std::make_shared<std::string>();
  command->add_option("DIR", *folder, "folder of a run")->required()->type_name("");
  command->footer("Example:\n  sabo info demo-run");
  command->callback([&action, folder] {
    action = {"", [folder] {
                fmt::print("{}", run_info_text(*folder));
                return exit_done;
              }};
  });
}

}  // namespace sabo
