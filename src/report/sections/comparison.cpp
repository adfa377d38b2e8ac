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
                                      KnownQuantity{"stored in the basin of ", "number.stored"},
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
    return report.say(known.key, name) + shown_unit(label.substr(unit));
  }
  return shown_unit(label);
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
  page.text(say("compare.runs", title_of(*other), other->folder().filename().string()));
  const auto here = run.number("run", "simulated_s"), there = other->number("run", "simulated_s");
  if (here && there && fixed(*here, 0) != fixed(*there, 0))
    page.text(say("compare.ends", fixed(*here, 1), fixed(*there, 1)));
  compare_quantities(report);
  if (const NumberTable* table = run.series("discharge.csv"))
    for (const std::string& section : names_before(*table, " net discharge [m3/s]"))
      compare_series(report, "discharge.csv", section + " net discharge [m3/s]",
                     say("compare.discharge", section), say("axis.discharge"));
  compare_series(report, "front.csv", "displacement [m]", say("compare.front"),
                 say("axis.displacement"));
}

/// A table of any columns as its file has it, or its beginning.
void show_table(Report& report, const fs::path& file, const std::string& name) {
  const auto content = read_file(file, max_picture);
  if (!content) return;
  ReportTable table;
  std::string_view rest = *content;
  bool is_cut = false;
  while (!rest.empty()) {
    std::vector<std::string> fields = next_csv_line(rest).value_or(std::vector<std::string>{});
    is_cut = is_cut || fields.size() > max_columns || table.rows.size() == max_rows;
    if (table.rows.size() == max_rows) break;
    if (fields.size() > max_columns) fields.resize(max_columns);
    for (std::string& field : fields) field = shown_unit(field);
    if (!table.header.empty())
      for (std::string& field : fields)
        if (const double value = number_of_field(field); std::isfinite(value))
          field = amount(value);
    if (table.header.empty())
      table.header = std::move(fields);
    else
      table.rows.push_back(std::move(fields));
  }
  table.source = data_line(report, {name});
  report.page.table(table);
  if (is_cut) report.page.text(report.say("compare.cut", name));
}

/// Of the pictures of two runs beside each other those that say most; the rest is on their page.
constexpr std::array<std::string_view, 3> chosen_of_two{"reached", "diff_pfd", "diff_dep"};

bool is_shown(std::string_view part, const fs::path& picture) {
  return part != "compare" ||
         std::ranges::find(chosen_of_two, picture.stem().string()) != chosen_of_two.end();
}

/// Files of one kind that a command left in a folder within the run, sorted.
std::vector<fs::path> products(const RunRecord& run, const char* part, const char* kind,
                               const char* extension) {
  std::vector<fs::path> files;
  std::error_code error;
  fs::directory_iterator entry(run.folder() / part / kind, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error))
    if (entry->path().extension() == extension) files.push_back(entry->path());
  std::ranges::sort(files);
  return files;
}

/// Which folders stand behind the letters a, b, ... of a product.
std::string runs_of(const RunRecord& run, const char* part) {
  const auto content = read_file(run.folder() / part / "result.toml", largest_text);
  Faults faults;
  const auto result = content ? parse_toml(*content, "result.toml", faults) : std::nullopt;
  const TomlNode* runs = result ? find(table_at(*result, "result"), "runs") : nullptr;
  const auto* list = runs ? std::get_if<TomlArray>(&runs->value) : nullptr;
  std::string text;
  for (std::size_t k = 0; list && k < list->size() && k < 26; ++k)
    if (const auto* folder = std::get_if<std::string>(&(*list)[k].value))
      text += fmt::format("{}{}: {}", k == 0 ? "" : "; ", static_cast<char>('a' + k), *folder);
  return text;
}

/// Tables and pictures of a command, as it left them.
void show_products(Report& report, const char* part, const char* about) {
  if (!report.run.has(std::string(part) + "/result.toml")) return;
  report.page.text(report.say(about, runs_of(report.run, part)));
  const auto name_of_file = [&](const fs::path& file) {
    return file.lexically_relative(report.run.folder()).generic_string();
  };
  for (const fs::path& file : products(report.run, part, "tables", ".csv"))
    if (!report.other || file.stem() != "quantities")  // which stand above, then
      show_table(report, file, name_of_file(file));
  for (const fs::path& file : products(report.run, part, "pictures", ".svg"))
    if (const auto svg = is_shown(part, file) ? read_file(file, max_picture) : std::nullopt)
      report.page.foreign_picture(*svg, data_line(report, {name_of_file(file)}));
}

}  // namespace

void add_comparison(Report& report) {
  const bool has_products =
      report.run.has("compare/result.toml") || report.run.has("observed/result.toml");
  if (!has_products && !report.other) return;
  report.page.section(report.say("compare.title"));
  if (report.other) compare_with_run(report);
  show_products(report, "compare", "compare.folder");
  show_products(report, "observed", "compare.observed");
}

void add_hazard(Report& report) {
  if (!report.run.has("hazard/result.toml")) return;
  report.page.section(report.say("hazard.title"));
  show_products(report, "hazard", "hazard.about");
}

}  // namespace sabo
