#include "report/report_parts.hpp"

#include <cmath>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "analysis/resolution.hpp"
#include "base/parsed_number.hpp"
#include "run/amount_text.hpp"
#include "run/load_case.hpp"

namespace sabo {
namespace {

std::string with_true_minus(std::string text) {
  if (text.starts_with('-')) text.replace(0, 1, "\u2212");
  return text;
}

}  // namespace

std::string data_line(const Report& report, std::initializer_list<std::string_view> files) {
  std::string list;
  for (const std::string_view file : files)
    list += fmt::format("{}{}", list.empty() ? "" : ", ", file);
  return report.say("page.data", list);
}

void tell_resolution(Report& report, double median, bool praises) {
  const auto& [run, other, say, page, sharpness] = report;
  const std::string layers = fixed(median, 1);
  if (median < ResolutionGuard::enough_layers)
    page.notice(Tone::alarm, say("resolution.coarse"), say("resolution.coarse_means", layers));
  else if (median < ResolutionGuard::good_layers)
    page.notice(Tone::caution, say("resolution.barely"), say("resolution.barely_means", layers));
  else if (praises)
    page.notice(Tone::good, say("resolution.good"), say("resolution.good_means", layers));
}

void tell_missing(Report& report, const std::string& file) {
  report.page.text(report.say("page.missing_file", file));
}

std::string amount(double value) { return with_true_minus(amount_text(value)); }

std::string fixed(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text.find_first_of("123456789") == text.npos && text.starts_with('-')) text.erase(0, 1);
  return with_true_minus(text);
}

std::string percent(double share, int decimals) { return fixed(100 * share, decimals) + " %"; }

std::string amount_or_dash(const std::optional<double>& value) {
  return value ? amount(*value) : "–";
}

std::string shown_unit(std::string text) {
  for (const auto& [plain, raised] : {std::pair{"m2", "m²"}, {"m3", "m³"}, {"s2", "s²"}}) {
    const std::size_t at = text.rfind(plain);
    const bool is_a_unit =
        at != text.npos &&
        (at == 0 || std::string_view("[/ ").find(text[at - 1]) != std::string_view::npos);
    if (is_a_unit) text.replace(at, 2, raised);
  }
  return text;
}

std::string shown_file(const std::string& path) {
  const std::filesystem::path file(path);
  return file.is_absolute() ? file.filename().string() : path;
}

double number_of_field(const std::string& field) {
  return parsed_number<double>(field).value_or(std::nan(""));
}

std::optional<Peak> peak_of(const NumberTable& table, const std::string& column) {
  const std::vector<double>* time = table.find("time [s]");
  const std::vector<double>* values = table.find(column);
  std::optional<Peak> peak;
  for (std::size_t k = 0; time && values && k < values->size(); ++k) {
    const double value = (*values)[k];
    const bool is_greater = !peak || std::abs(value) > std::abs(peak->value);
    if (std::isfinite(value) && is_greater) peak = Peak{value, (*time)[k]};
  }
  return peak;
}

std::vector<std::string> names_before(const NumberTable& table, std::string_view suffix) {
  std::vector<std::string> names;
  for (const std::string& name : table.names)
    if (name.ends_with(suffix)) names.push_back(name.substr(0, name.size() - suffix.size()));
  return names;
}

ChartSeries over_time(const NumberTable& table, const std::string& column, const std::string& name,
                      double scale) {
  ChartSeries series{name};
  const std::vector<double>* time = table.find("time [s]");
  const std::vector<double>* values = table.find(column);
  if (!time || !values) return series;
  series.x = *time;
  series.y = *values;
  for (double& value : series.y) value *= scale;
  return series;
}

std::string title_of(const RunRecord& run) {
  const std::string title = run.written("", "title");
  return title.empty() ? name_of_case(run.folder()) : title;
}

}  // namespace sabo
