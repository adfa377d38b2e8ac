#include <memory>

#include "report/write_report.hpp"
#include <fmt/format.h>

#include "app/commands.hpp"

namespace sabo {
namespace {

struct ReportCommandOptions {
  std::string folder;
  std::string language = "en";
  ReportOptions report;
};

}  // namespace

void add_report_command(CLI::App& program, Action& action) {
  CLI::App* command = program.add_subcommand(
      "report", "Write one page on a run that can be printed and needs no network");
  const auto options = std::make_shared<ReportCommandOptions>();
  command->add_option("DIR", options->folder, "folder of a run")->required()->type_name("");
  command
      ->add_option("-o,--output", options->report.output,
                   "file of the report; default: report.html in the folder, report_ja.html for ja")
      ->type_name("FILE");
  command->add_option("--language", options->language, "en or ja; default: en")
      ->check(CLI::IsMember({"en", "ja"}))
      ->type_name("");
  command
      ->add_option("--compare", options->report.other,
                   "another run to set beside this one, e.g. without the dam; what `sabo compare` "
                   "left in the folder is shown in any case")
      ->type_name("DIR");
  command->footer(
      "Examples:\n  sabo report demo-run\n  sabo report demo-run --language ja -o report.html\n"
      "  sabo report with-dam --compare without-dam");
  command->callback([&action, options] {
    action = {"", [options] {
                options->report.language = *value_of_word<Language>(options->language);
                fmt::print("Open {}\n", write_report(options->folder, options->report).string());
                return exit_done;
              }};
  });
}

}  // namespace sabo
