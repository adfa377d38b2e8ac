#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "app/commands.hpp"
#include "base/error.hpp"
#include "base/faults.hpp"
#include "case/material_case.hpp"
#include "io/case_file/key_text.hpp"
#include "io/case_file/models.hpp"
#include "io/output/file.hpp"
#include "io/output/models_plot.hpp"

namespace sabo {
namespace {

struct ModelsOptions {
  bool plot = false;
  std::string folder = ".";
  // Those of figure 1 of the paper of 2016.
  double viscosity = 20;
  double yield_stress = 50;
  double pressure = 0;
  // Bingham's fluid, the fluids that stand in for it, and what they become without yield stress.
  std::vector<std::string> laws{"bingham",   "cross",         "frigaard_nouar",
                                "threshold", "papanastasiou", "newtonian"};
};

Rheology law_named(const std::string& name, double viscosity) {
  for (Rheology law : all_rheologies()) {
    if (name_of(law) != name) continue;
    set_viscosity(law, viscosity);
    // The others are compared with the exact law, so its cap must be out of sight.
    if (auto* exact = std::get_if<Bingham>(&law)) exact->ratio = 1e6;
    return law;
  }
  const std::string near = nearest_word(name, rheology_names());
  throw CaseError("--laws", fmt::format("there is no law \"{}\"", name),
                  near.empty() ? "give " + words_text(rheology_names())
                               : fmt::format("did you mean \"{}\"?", near));
}

int list_or_plot(const ModelsOptions& options) {
  if (!options.plot) {
    fmt::print("{}", models_text());
    return exit_done;
  }
  std::vector<Rheology> laws;
  for (const std::string& name : options.laws) laws.push_back(law_named(name, options.viscosity));
  const ModelsPlot plot =
      plot_models(laws, {0, options.yield_stress, options.pressure},
                  fmt::format("plastic viscosity {:g} Pa s, yield stress {:g} Pa",
                              options.viscosity, options.yield_stress));
  const std::filesystem::path folder = options.folder;
  for (const auto& [file, chart] : {std::pair{"effective_viscosity.svg", plot.effective_viscosity},
                                    std::pair{"shear_stress.svg", plot.shear_stress}}) {
    write_file_atomically(folder / file, chart_svg(chart));
    fmt::print("Wrote {}\n", (folder / file).lexically_normal().string());
  }
  return exit_done;
}

}  // namespace

void add_models_command(CLI::App& program, Action& action) {
  CLI::App* command =
      program.add_subcommand("models", "List the laws of flow and material presets, or draw laws");
  const auto options = std::make_shared<ModelsOptions>();
  command->add_flag("--plot", options->plot,
                    "draw effective viscosity and stress against shear rate");
  command->add_option("-o,--output", options->folder, "folder of the pictures; default: this one")
      ->type_name("DIR")
      ->check(CLI::Validator(CLI::ExistingDirectory).description(""));
  command->add_option("--viscosity", options->viscosity, "plastic viscosity of the laws drawn")
      ->type_name("PA S")
      ->check(CLI::Range(1e-9, 1e9).description(""))
      ->capture_default_str();
  command->add_option("--yield-stress", options->yield_stress, "yield stress of the laws drawn")
      ->type_name("PA")
      ->check(CLI::Range(0.0, 1e9).description(""))
      ->capture_default_str();
  command->add_option("--pressure", options->pressure, "effective pressure, for mu_i")
      ->type_name("PA")
      ->check(CLI::Range(0.0, 1e9).description(""))
      ->capture_default_str();
  command->add_option("--laws", options->laws, "laws to draw")
      ->delimiter(',')
      ->type_name("LAW,LAW,...")
      ->capture_default_str();
  command->footer(
      "Examples:\n  sabo models\n  sabo models --plot\n"
      "  sabo models --plot --laws bingham,herschel_bulkley,quadratic --yield-stress 200");
  command->callback([&action, options] {
    action = {"", [options] { return list_or_plot(*options); }};
  });
}

}  // namespace sabo
