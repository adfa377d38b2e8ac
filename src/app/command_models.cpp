#include <fmt/format.h>

#include "app/commands.hpp"
#include "io/case_file/models.hpp"

namespace sabo {

void add_models_command(CLI::App& program, Action& action) {
  CLI::App* command =
      program.add_subcommand("models", "List the laws of flow with their keys and defaults");
  command->callback([&action] {
    action = {"", [] {
                fmt::print("{}", models_text());
                return exit_done;
              }};
  });
}

}  // namespace sabo
