#include <memory>

#include <fmt/format.h>

#include "app/case_option.hpp"
#include "app/commands.hpp"
#include "io/case_file/write_case.hpp"
#include "io/output/file.hpp"
#include "run/load_case.hpp"
#include "run/preview.hpp"
#include "run/preview_picture.hpp"
#include "run/scene.hpp"

namespace sabo {
namespace {

struct CheckOptions {
  std::string case_path;
  std::string picture;
  bool defaults = false;
  std::vector<Override> overrides;
};

int check_case(const CheckOptions& options) {
  if (options.case_path.empty()) {
    fmt::print("{}", defaults_text());
    return exit_done;
  }
  Faults faults;
  const Case c = load_case(options.case_path, faults, options.overrides);
  faults.throw_if_any();
  if (options.defaults) {
    fmt::print("{}", write_case(c));
    return exit_done;
  }
  const Scene scene = make_scene(c, faults);
  faults.throw_if_any();
  fmt::print("{}", preview_text(c, scene));
  const std::string picture =
      options.picture.empty() ? c.folder.filename().string() + "-check.svg" : options.picture;
  write_file_atomically(picture, preview_svg(c, scene));
  fmt::print("\nPicture: {}\n", picture);
  return exit_done;
}

}  // namespace

void add_check_command(CLI::App& program, Action& action) {
  CLI::App* command =
      program.add_subcommand("check", "Read a case with its files, say and draw what it holds");
  const auto options = std::make_shared<CheckOptions>();
  CLI::Option* path = command
                          ->add_option("CASE", options->case_path,
                                       "case file, folder with a case.toml, or AvaFrame project")
                          ->type_name("");
  command->add_flag("--defaults", options->defaults,
                    "print every key with its value and meaning; without CASE, its default");
  command
      ->add_option("-o,--output", options->picture,
                   "picture to draw; default: name of the case's folder with -check.svg")
      ->type_name("FILE");
  add_case_option(*command, "numerics", "spacing", options->overrides);
  add_case_option(*command, "run", "duration", options->overrides);
  command->footer(
      "Examples:\n  sabo check demo\n  sabo check demo --spacing 1.5\n  sabo check --defaults");
  command->callback([&action, options, path] {
    if (path->empty() && !options->defaults) throw CLI::RequiredError("CASE");
    action = {options->case_path, [=] { return check_case(*options); }};
  });
}

}  // namespace sabo
