#include <filesystem>
#include <memory>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/commands.hpp"
#include "base/shell_word.hpp"
#include "io/case_file/templates.hpp"
#include "run/new_case.hpp"

namespace sabo {
namespace {

struct NewOptions {
  std::string template_name;
  std::string folder;
};

int make_case(const NewOptions& options) {
  new_case(options.template_name, options.folder);
  std::set<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(options.folder)) {
    files.insert(entry.path().filename().string());
  }
  fmt::print("Wrote {}: {}\n", options.folder, fmt::join(files, ", "));
  fmt::print("Look at case.toml, then\n  sabo check {0}\n  sabo run {0}\n",
             shell_word(options.folder));
  return exit_done;
}

std::string template_list() {
  std::string text = "Templates:";
  for (const Template& entry : templates) {
    text += fmt::format("\n  {:<16} {}", entry.name, entry.summary);
  }
  return text;
}

}  // namespace

void add_new_command(CLI::App& program, Action& action) {
  CLI::App* command = program.add_subcommand("new", "Write a case to start from");
  const auto options = std::make_shared<NewOptions>();
  command->add_option("TEMPLATE", options->template_name, "one of those below")
      ->required()
      ->type_name("");
  command->add_option("DIR", options->folder, "folder to make, or an empty one")
      ->required()
      ->type_name("");
  command->footer(template_list() + "\n\nExample:\n  sabo new yohutagawa demo");
  command->callback([&action, options] { action = {"", [=] { return make_case(*options); }}; });
}

}  // namespace sabo
