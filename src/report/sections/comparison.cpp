#include <algorithm>
#include <array>
#include <cmath>

#include "report/report_parts.hpp"
#include <fmt/format.h>

#include "io/output/read_file.hpp"

namespace sabo {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_rows = 60, max_columns = 10, max_picture = 20'000'000;

struct KnownQuantity {
  std::string_view start;  ///< of the label; a name may follow
  const char* key;         ///< of the texts
};
constexpr std::array known_quantities{KnownQuantity{"front run-out", "number.runout"},
                                      KnownQuantity{"peak front speed", "number.front_speed"},
                                      KnownQuantity{"arrival at ", "number.arrival"},
                                      KnownQuantity{"trapped by ", "number.trapped"},
                                      KnownQuantity{"beyond ", "number.beyond"},
                                      KnownQuantity{"peak discharge at ", "number.discharge"},
                                      KnownQuantity{"left the map", "number.left"},
                                      KnownQuantity{"deposit area", "number.deposit_area"},
                                      KnownQuantity{"deposit mean depth", "number.deposit_depth"}};

/// A label of [quantities], "arrival at dam [s]", in the language of the report.
std::string label_of(const Report& report, const std::string& label) {
  const std::size_t unit = label.rfind(" [");
  if (unit == label.npos) return label;
  for (const KnownQuantity& known : known_quantities) {
    if (!label.starts_with(known.start) || known.start.size() > unit) continue;
    const std::string name = label.substr(known.start.size(), unit - known.start.size());
    return report.say(known.key, name) + label.substr(unit);
  }
  return label;
}

void compare_quantities(Report& report) {
  ReportTable table;
  table.caption = report.say("compare.quantities");
  table.header = {"", report.say("column.run"), report.say("compare.other"),
                  report.say("compare.difference"), report.say("compare.share")};
  for (const TomlEntry& entry : report.run.table("quantities")) {
    const auto here = report.run.quantity(entry.key), there = report.other->quantity(entry.key);
    if (!here && !there) continue;
    const bool is_in_both = here && there;
    table.rows.push_back(
        {label_of(report, entry.key), amount_or_dash(here), amount_or_dash(there),
         is_in_both ? amount(*here - *there) : "–",
         is_in_both && *there != 0 ? percent((*here - *there) / std::abs(*there), 1) : "–"});
  }
  table.source = data_line(report, {"manifest.toml [quantities]"});
  report.page.table(table);
}

/// A column of both runs in one chart.
void compare_series(Report& report, const std::string& file, const std::string& column,
                    const std::string& title, const std::string& axis) {
  const NumberTable* here = report.run.series(file);
  const NumberTable* there = report.other->series(file);
  if (!here || !there || !here->find(column) || !there->find(column)) return;
  LineChart chart{title, report.say("axis.time"), axis};
  chart.series = {over_time(*here, column, report.say("column.run")),
                  over_time(*there, column, report.say("compare.other"))};
  report.page.chart(chart, data_line(report, {"series/" + file}));
}

void compare_with_run(Report& report) {
  const auto& [run, other, say, page, sharpness] = report;
  page.text(say("compare.runs", title_of(*other), other->folder().string()));
  compare_quantities(report);
  if (const NumberTable* table = run.series("discharge.csv"))
    for (const std::string& section : names_before(*table, " net discharge [m3/s]"))
      compare_series(report, "discharge.csv", section + " net discharge [m3/s]",
                     say("compare.discharge", section), say("axis.discharge"));
  compare_series(report, "front.csv", "displacement [m]", say("compare.front"),
                 say("axis.displacement"));
}

/// A table of any columns, as its file has it.
void show_table(Report& report, const fs::path& file, const std::string& name) {
  const auto content = read_file(file, max_picture);
  if (!content) return;
  ReportTable table;
  std::string_view rest = *content;
  while (!rest.empty() && table.rows.size() < max_rows) {
    std::vector<std::string> fields = next_csv_line(rest).value_or(std::vector<std::string>{});
    if (fields.size() > max_columns) fields.resize(max_columns);
    if (table.header.empty())
      table.header = std::move(fields);
    else
      table.rows.push_back(std::move(fields));
  }
  table.source = data_line(report, {name});
  report.page.table(table);
}

/// What `sabo compare` left in the folder of the run: another run, a survey.
std::vector<fs::path> files_of_comparison(const RunRecord& run) {
  std::vector<fs::path> files;
  for (const char* part : {"compare", "observed"}) {
    std::error_code error;
    fs::recursive_directory_iterator entry(run.folder() / part,
                                           fs::directory_options::skip_permission_denied, error);
    for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error))
      if (entry->is_regular_file(error)) files.push_back(entry->path());
  }
  std::ranges::sort(files);
  return files;
}

}  // namespace

void add_comparison(Report& report) {
  const std::vector<fs::path> files = files_of_comparison(report.run);
  if (files.empty() && !report.other) return;
  report.page.section(report.say("compare.title"));
  if (report.other) compare_with_run(report);
  if (files.empty()) return;
  report.page.text(report.say("compare.folder"));
  for (const fs::path& file : files) {
    const std::string name = file.lexically_relative(report.run.folder()).generic_string();
    if (file.extension() == ".csv") show_table(report, file, name);
    if (file.extension() == ".svg")
      if (const auto svg = read_file(file, max_picture))
        report.page.foreign_picture(*svg, data_line(report, {name}));
  }
}

}  // namespace sabo
