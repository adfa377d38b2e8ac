#include <memory>

#include <fmt/format.h>

#include "app/case_option.hpp"
#include "app/commands.hpp"
#include "base/error.hpp"
#include "io/case_file/write_case.hpp"
#include "io/output/file.hpp"
#include "run/cost_forecast.hpp"
#include "run/load_case.hpp"
#include "run/preview.hpp"
#include "run/preview_picture.hpp"
#include "run/scene.hpp"
#include "solver/make_backend.hpp"

namespace sabo {
namespace {

struct CheckOptions {
  std::string case_path;
  std::string picture;
  bool defaults = false;
  bool no_forecast = false;
  std::vector<Override> overrides;
};

/// Without a name of its own the picture is an extra: a folder that cannot be written is no fault
/// of the case.
void draw_preview(const CheckOptions& options, const std::string& svg) {
  const bool is_named = !options.picture.empty();
  const std::string file =
      is_named ? options.picture : name_of_case(options.case_path) + "-check.svg";
  try {
    write_file_atomically(file, svg);
    fmt::print("\nPicture: {}\n", file);
  } catch (const RunError& error) {
    if (is_named) throw;
    fmt::print("\nNo picture: {}\n", error.what());
  }
}

/// How long the run will take, or why that cannot be told.
std::string time_text(const Case& c, const Scene& scene) {
  if (!missing_backend(c.numerics.backend).empty())
    return "not known, for the backend is missing on this machine";
  try {
    return forecast_text(measured_forecast(c, scene));
  } catch (const RunError& error) {
    return fmt::format("not known, for the first steps fail: {}", error.what());
  }
}

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
  fmt::print("{}", preview_text(c, scene, options.no_forecast ? "" : time_text(c, scene)));
  draw_preview(options, preview_svg(c, scene));
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
  command->add_flag("--no-forecast", options->no_forecast,
                    "do not step the flow for a second or two to tell how long the run will take");
  add_case_option(*command, "numerics", "spacing", options->overrides);
  add_run_options(*command, options->overrides);
  command->footer(
      "Examples:\n  sabo check demo\n  sabo check demo --spacing 1.5\n  sabo check --defaults");
  command->callback([&action, options, path] {
    if (path->empty() && !options->defaults) throw CLI::RequiredError("CASE");
    action = {options->case_path, [=] { return check_case(*options); }};
  });
}

}  // namespace sabo
