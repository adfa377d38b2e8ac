#include "report/write_report.hpp"

#include <optional>

#include "report/report_parts.hpp"

#include "base/version.hpp"
#include "io/output/file.hpp"
#include "run/manifest.hpp"

namespace sabo {
namespace {

void add_sections(Report& report) {
  add_summary(report);
  add_site(report);
  add_release(report);
  add_parameters(report);
  add_structures(report);
  add_maps(report);
  add_profile(report);
  add_hydrographs(report);
  add_gauges(report);
  add_front(report);
  add_balance(report);
  add_loads(report);
  add_zones(report);
  add_comparison(report);
  add_hazard(report);
  add_resolution(report);
  add_ledger(report);
  add_limits(report);
  add_inputs(report);
  add_files(report);
}

}  // namespace

std::filesystem::path write_report(const std::filesystem::path& run_folder,
                                   const ReportOptions& options) {
  RunRecord run(run_folder);
  std::optional<RunRecord> other;
  if (!options.other.empty()) other.emplace(options.other);
  const Phrases say(options.language);
  HtmlPage page;
  Report report{run, other ? &*other : nullptr, say, page, options.sharpness};
  add_sections(report);
  const bool is_english = options.language == Language::en;
  const std::filesystem::path file =
      !options.output.empty() ? options.output
                              : run_folder / (is_english ? "report.html" : "report_ja.html");
  write_file_atomically(file,
                        page.html({std::string(word_of(options.language)), title_of(run),
                                   say("page.footer", build_version, utc_now().substr(0, 10))}));
  return file;
}

}  // namespace sabo
