#include <memory>

#include "post/export_run.hpp"
#include <fmt/format.h>

#include "app/commands.hpp"

namespace sabo {

void add_export_command(CLI::App& program, Action& action) {
  CLI::App* command = program.add_subcommand(
      "export", "Write a run for other software: ESRI ASCII, GeoPackage, styles for QGIS");
  const auto options = std::make_shared<ExportOptions>();
  command->add_option("RUN", options->run, "folder of a run")->required()->type_name("");
  command
      ->add_option("--format", options->formats,
                   "ascii: grids of every map; gpkg: outlines of the affected area and what stands "
                   "on the map; qgis: GeoTIFFs with styles; default: all")
      ->delimiter(',')
      ->type_name("F,F,...");
  command->add_option("--depths", options->depths, "depths of the outlines; default: 0.1,0.5,1,2")
      ->delimiter(',')
      ->type_name("M,M,...");
  command->add_option("-o,--output", options->output, "folder to write; default: export in the run")
      ->type_name("DIR");
  command->footer(
      "Examples:\n  sabo export demo-run\n  sabo export demo-run --format gpkg --depths 0.2,1");
  command->callback([&action, options] {
    action = {"", [options] {
                for (const std::string& line : export_run(*options)) fmt::print("{}\n", line);
                return exit_done;
              }};
  });
}

}  // namespace sabo
