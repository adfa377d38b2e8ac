#include "run/sweep_page.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/parsed_number.hpp"
#include "base/version.hpp"
#include "io/output/csv.hpp"
#include "io/output/file.hpp"
#include "io/output/svg_chart.hpp"
#include "run/study_table.hpp"

namespace sabo {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> labels_of(const SweepTable& table) {
  std::vector<BatchRecord> records;
  for (const SweepRow& row : table.rows) records.push_back(row.record);
  return quantity_labels(records);
}

std::string sweep_csv(const SweepTable& table) {
  std::vector<std::string> header{"folder"};
  header.insert(header.end(), table.keys.begin(), table.keys.end());
  const std::vector<std::string> labels = labels_of(table);
  header.insert(header.end(), labels.begin(), labels.end());
  std::string text = csv_line(header);
  for (const SweepRow& row : table.rows) {
    std::vector<std::string> fields{row.record.folder};
    fields.insert(fields.end(), row.values.begin(), row.values.end());
    for (const std::string& label : labels) {
      const auto value = row.record.quantity(label);
      fields.push_back(value ? fmt::format("{:.9g}", *value) : "");
    }
    text += csv_line(fields);
  }
  return text;
}

/// A quantity over the first key, a line for each combination of the others; none when the key has
/// no numbers or fewer than two.
std::optional<LineChart> chart_of(const SweepTable& table, const std::string& label) {
  LineChart chart{label.substr(0, label.rfind(" [")), table.keys[0], label};
  std::map<std::string, std::size_t> lines;
  for (const SweepRow& row : table.rows) {
    const auto x = parsed_number<double>(row.values[0]);
    const auto y = row.record.quantity(label);
    if (!x) return std::nullopt;
    if (!y) continue;
    std::string name;
    for (std::size_t k = 1; k < row.values.size(); ++k)
      name += fmt::format("{}{} {}", k > 1 ? ", " : "",
                          table.keys[k].substr(table.keys[k].rfind('.') + 1), row.values[k]);
    const auto [line, is_new] = lines.try_emplace(name, chart.series.size());
    if (is_new) {
      chart.series.push_back({name.empty() ? chart.title : name});
      chart.series.back().has_markers = true;
    }
    chart.series[line->second].x.push_back(*x);
    chart.series[line->second].y.push_back(*y);
  }
  const bool has_line = std::ranges::any_of(
      chart.series, [](const ChartSeries& series) { return series.x.size() > 1; });
  return has_line ? std::optional(std::move(chart)) : std::nullopt;
}

}  // namespace

PageTable sweep_table(const SweepTable& table) {
  PageTable page;
  page.caption = "Results of each run";
  page.header = table.keys;
  const std::vector<std::string> labels = labels_of(table);
  page.header.insert(page.header.end(), labels.begin(), labels.end());
  for (const SweepRow& row : table.rows) {
    std::vector<std::string> cells = row.values;
    for (const std::string& label : labels) {
      const auto value = row.record.quantity(label);
      cells.push_back(value ? number_text(*value) : "-");
    }
    page.rows.push_back(std::move(cells));
  }
  return page;
}

fs::path write_sweep(const SweepPage& sweep, const fs::path& folder) {
  make_folder(folder / "pictures");
  remove_named(folder / "pictures", "quantity_");
  write_file_atomically(folder / "runs.csv", sweep_csv(sweep.table));
  IndexPage page;
  page.title = fmt::format("{}: sweep", sweep.c.title.empty() ? "Debris flow" : sweep.c.title);
  page.subtitle = fmt::format("sabo {} · {} runs over {}", build_version, sweep.table.rows.size(),
                              fmt::join(sweep.table.keys, ", "));
  page.note = sweep.c.note;
  page.warning = sweep.warning;
  page.tables = {sweep_table(sweep.table)};
  page.pictures = sweep.pictures;
  int number = 0;
  for (const std::string& label : labels_of(sweep.table)) {
    const auto chart = chart_of(sweep.table, label);
    if (!chart) continue;
    const std::string name = fmt::format("pictures/quantity_{:02}.svg", ++number);
    write_file_atomically(folder / name, chart_svg(*chart));
    page.pictures.push_back({{name}, label + " over " + sweep.table.keys[0], false});
  }
  page.files = {{"runs.csv", "the quantities of each run"}};
  for (const SweepRow& row : sweep.table.rows)
    page.files.push_back({row.record.folder + "/index.html", "the run"});
  fs::path file = folder / "index.html";
  write_file_atomically(file, index_html(page));
  return file;
}

}  // namespace sabo
