#include "run/study_page.hpp"

#include <algorithm>
#include <cmath>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/version.hpp"
#include "io/case_file/toml_string.hpp"
#include "io/output/csv.hpp"
#include "io/output/file.hpp"
#include "io/output/svg_chart.hpp"

namespace sabo {
namespace {

namespace fs = std::filesystem;

std::string number(double value) { return fmt::format("{:.9g}", value); }

/// One line a quantity; empty fields where there is no value.
std::string table_csv(const StudyTable& table) {
  std::vector<std::string> header{"quantity"};
  for (const double spacing : table.spacings) {
    header.push_back(fmt::format("at {} m", spacing));
    if (table.has_members) header.push_back(fmt::format("standard deviation at {} m", spacing));
  }
  for (const char* title :
       {"convergence", "order", "extrapolated", "uncertainty", "lowest", "highest"})
    header.emplace_back(title);
  std::string text = csv_line(header);
  for (const StudyRow& row : table.rows) {
    std::vector<std::string> fields{row.label};
    for (const auto& value : row.at) {
      fields.push_back(value ? number(value->scatter.mean) : "");
      if (table.has_members) fields.push_back(value ? number(value->scatter.deviation) : "");
    }
    const GridConvergence& result = row.convergence;
    fields.emplace_back(word_of(result.kind));
    fields.push_back(result.has_limit() ? number(result.order) : "");
    fields.push_back(row.shows_limit() ? number(result.extrapolated) : "");
    fields.push_back(result.has_limit() ? number(result.uncertainty) : "");
    fields.push_back(number(result.lowest));
    fields.push_back(number(result.highest));
    text += csv_line(fields);
  }
  return text;
}

/// One line a run.
std::string runs_csv(const std::vector<BatchRecord>& records, const StudyTable& table) {
  std::vector<std::string> header{"folder",
                                  "spacing [m]",
                                  "member",
                                  "particles",
                                  "simulated [s]",
                                  "at rest",
                                  "median particles in the depth",
                                  "wall time [s]"};
  for (const StudyRow& row : table.rows) header.push_back(row.label);
  std::string text = csv_line(header);
  for (const BatchRecord& record : records) {
    std::vector<std::string> fields{record.folder,
                                    number(record.spacing),
                                    std::to_string(record.member),
                                    number(record.particles),
                                    number(record.simulated),
                                    record.at_rest ? "1" : "0",
                                    number(record.median_layers),
                                    number(record.wall)};
    for (const StudyRow& row : table.rows) {
      const auto value = record.quantity(row.label);
      fields.push_back(value ? number(*value) : "");
    }
    text += csv_line(fields);
  }
  return text;
}

std::string study_toml(const std::vector<BatchRecord>& records, const StudyTable& table) {
  std::string text =
      fmt::format("# Written by sabo.\n[study]\nversion = {}\nspacings = [{}]  # m\nruns = {}\n",
                  toml_string(build_version), fmt::join(table.spacings, ", "), records.size());
  for (const StudyRow& row : table.rows) {
    const GridConvergence& result = row.convergence;
    text += fmt::format("\n[[quantity]]\nname = {}\nconvergence = {}\nlowest = {}\nhighest = {}\n",
                        toml_string(row.label), toml_string(std::string(word_of(result.kind))),
                        number(result.lowest), number(result.highest));
    if (result.has_limit())
      text += fmt::format("order = {}\nuncertainty = {}\n", number(result.order),
                          number(result.uncertainty));
    if (row.shows_limit()) text += fmt::format("extrapolated = {}\n", number(result.extrapolated));
  }
  return text;
}

/// The power law through the two finest means from the spacing of zero on.
ChartSeries fitted_curve(const StudyRow& row, const StudyTable& table) {
  constexpr int pieces = 40;
  const GridConvergence& result = row.convergence;
  double fine = 0, value = 0;
  for (std::size_t k = 0; k < row.at.size(); ++k)
    if (row.at[k]) fine = table.spacings[k], value = row.at[k]->scatter.mean;
  ChartSeries curve{fmt::format("order {:.2f}", result.order)};
  for (int i = 0; i <= pieces; ++i) {
    const double spacing = table.spacings.front() * i / pieces;
    curve.x.push_back(spacing);
    curve.y.push_back(result.extrapolated +
                      (value - result.extrapolated) * std::pow(spacing / fine, result.order));
  }
  return curve;
}

std::string chart_of(const StudyRow& row, const std::vector<BatchRecord>& records,
                     const StudyTable& table) {
  const std::string name = row.label.substr(0, row.label.rfind(" ["));
  LineChart chart{name, "particle spacing [m]", row.label};
  const GridConvergence& result = row.convergence;
  const bool has_curve = row.shows_limit() && result.order > 0;
  ChartSeries runs{"runs", {}, {}, true, !has_curve && !table.has_members};
  for (const BatchRecord& record : records)
    if (const auto value = record.quantity(row.label))
      runs.x.push_back(record.spacing), runs.y.push_back(*value);
  double low = std::ranges::min(runs.y), high = std::ranges::max(runs.y);
  if (has_curve) chart.series.push_back(fitted_curve(row, table));
  chart.series.push_back(std::move(runs));
  if (has_curve) {
    chart.series.push_back({"extrapolated", {0}, {result.extrapolated}, true, false});
    low = std::min(low, result.extrapolated);
    high = std::max(high, result.extrapolated);
  }
  // Changes are to be seen; without any the axis starts at 0.
  if (high > low) chart.y_low = low, chart.y_high = high;
  chart.x_low = 0;
  chart.x_high = table.spacings.front();
  return chart_svg(chart);
}

IndexPage page_of(const Case& c, const std::vector<BatchRecord>& records, const StudyTable& table,
                  const std::vector<std::string>& warnings) {
  IndexPage page;
  page.title = fmt::format("{}: study of the spacing", c.title.empty() ? "Debris flow" : c.title);
  page.subtitle = fmt::format("sabo {} · {} runs at {:g} to {:g} m", build_version, records.size(),
                              table.spacings.front(), table.spacings.back());
  page.note = c.note;
  page.warning = fmt::format("{}", fmt::join(warnings, ". "));
  page.tables = {quantities_table(table)};
  std::string members;
  if (table.has_members)
    members =
        "Values are means over the jittered starts at a spacing, s their standard deviation. ";
  page.remarks =
      members +
      "Uncertainty: grid convergence index of the value at the finest spacing, ± (Roache "
      "1994; Celik et al. 2008), with a safety factor of 1.25, of two spacings 3. Extrapolated: "
      "generalised Richardson extrapolation over the three finest spacings with the "
      "order that they show.";
  page.details = {runs_table(records)};
  page.files = {{"table.csv", "the quantities by spacing"},
                {"runs.csv", "the quantities of each run"},
                {"study.toml", "orders, extrapolated values and uncertainties"}};
  for (const BatchRecord& record : records)
    page.files.push_back({record.folder + "/index.html",
                          fmt::format("the run at {:g} m{}", record.spacing,
                                      record.member > 0 ? fmt::format(", member {}", record.member)
                                                        : std::string())});
  return page;
}

}  // namespace

fs::path write_study(const fs::path& folder, const Case& c, const std::vector<BatchRecord>& records,
                     const StudyTable& table, const std::vector<std::string>& warnings) {
  std::error_code error;
  const fs::path pictures = folder / "pictures";
  fs::remove_all(pictures, error);
  make_folder(pictures);
  write_file_atomically(folder / "table.csv", table_csv(table));
  write_file_atomically(folder / "runs.csv", runs_csv(records, table));
  write_file_atomically(folder / "study.toml", study_toml(records, table));
  IndexPage page = page_of(c, records, table, warnings);
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    if (table.rows[k].convergence.kind == Convergence::unchanged) continue;  // a level line
    const std::string name = fmt::format("pictures/quantity_{:02}.svg", k + 1);
    write_file_atomically(folder / name, chart_of(table.rows[k], records, table));
    page.pictures.push_back({{name}, table.rows[k].label + " by particle spacing", false});
  }
  fs::path file = folder / "index.html";
  write_file_atomically(file, index_html(page));
  return file;
}

}  // namespace sabo
