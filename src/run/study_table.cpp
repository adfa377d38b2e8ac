#include "run/study_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/resolution.hpp"

namespace sabo {
namespace {

// Celik et al. (2008): below it rounding and scatter pass for an order.
constexpr double least_ratio = 1.3;

std::optional<StudyRow::Value> value_at(const std::vector<BatchRecord>& records, double spacing,
                                        const std::string& label) {
  std::vector<double> values;
  for (const BatchRecord& record : records) {
    if (record.spacing != spacing) continue;
    if (const auto value = record.quantity(label)) values.push_back(*value);
  }
  if (values.empty()) return std::nullopt;
  return StudyRow::Value{scatter_of(values), values.size()};
}

/// Whether the change between the two finest means is less than twice its standard error.
bool is_within_scatter(const StudyRow& row) {
  std::vector<StudyRow::Value> present;
  for (const auto& value : row.at)
    if (value) present.push_back(*value);
  if (present.size() < 2) return false;
  const StudyRow::Value &fine = present.back(), &next = present[present.size() - 2];
  const auto variance = [](const StudyRow::Value& value) {
    return value.scatter.deviation * value.scatter.deviation / static_cast<double>(value.runs);
  };
  const double error = std::sqrt(variance(fine) + variance(next));
  return error > 0 && std::abs(fine.scatter.mean - next.scatter.mean) < 2 * error;
}

std::string remark_on(const StudyRow& row) {
  std::vector<std::string> remarks;
  const GridConvergence& result = row.convergence;
  switch (result.kind) {
    case Convergence::single:
      remarks.emplace_back("at one spacing only");
      break;
    case Convergence::first_order:
      remarks.emplace_back("two spacings: first order is assumed");
      break;
    case Convergence::monotone:
      if (result.order > greatest_trusted_order)
        remarks.push_back(fmt::format("uncertainty by order {:g}", greatest_trusted_order));
      if (row.is_far()) remarks.emplace_back("far from converged");
      break;
    case Convergence::unchanged:
      remarks.emplace_back("unchanged");
      break;
    case Convergence::no_order:
      remarks.push_back(fmt::format("no order: {} to {}", number_text(result.lowest),
                                    number_text(result.highest)));
      break;
  }
  if (result.has_limit() && row.falls_below_zero()) remarks.emplace_back("extrapolates below zero");
  const auto missing = std::ranges::count_if(row.at, [](const auto& value) { return !value; });
  if (missing > 0 && result.kind != Convergence::single)
    remarks.push_back(fmt::format("missing at {} of {} spacings", missing, row.at.size()));
  if (is_within_scatter(row)) remarks.emplace_back("last change within the scatter");
  return fmt::format("{}", fmt::join(remarks, "; "));
}

std::string study_value_text(const std::optional<StudyRow::Value>& value) {
  if (!value) return "-";
  const std::string mean = number_text(value->scatter.mean);
  return value->runs > 1 ? fmt::format("{} (s {})", mean, number_text(value->scatter.deviation, 2))
                         : mean;
}

}  // namespace

std::string number_text(double value, int digits) {
  const double size = std::abs(value);
  if (!(size >= 1e-4)) return value == 0 ? "0" : fmt::format("{:.2g}", value);
  const int whole_digits = static_cast<int>(std::floor(std::log10(size))) + 1;
  return fmt::format("{:.{}f}", value, std::clamp(digits - whole_digits, 0, 7));
}

StudyTable study_table(const std::vector<BatchRecord>& records) {
  StudyTable table;
  for (const BatchRecord& record : records) {
    table.spacings.push_back(record.spacing);
    table.has_members = table.has_members || record.member > 0;
  }
  std::ranges::sort(table.spacings, std::ranges::greater());
  table.spacings.erase(std::unique(table.spacings.begin(), table.spacings.end()),
                       table.spacings.end());

  for (const std::string& label : quantity_labels(records)) {
    StudyRow row;
    row.label = label;
    std::vector<GridSample> samples;
    for (const double spacing : table.spacings) {
      row.at.push_back(value_at(records, spacing, label));
      if (row.at.back()) samples.push_back({spacing, row.at.back()->scatter.mean});
    }
    row.convergence = grid_convergence(samples);
    row.remark = remark_on(row);
    table.rows.push_back(std::move(row));
  }
  return table;
}

PageTable quantities_table(const StudyTable& table) {
  PageTable page;
  page.caption = "Key quantities by particle spacing";
  page.header = {""};
  for (const double spacing : table.spacings) page.header.push_back(fmt::format("{:g} m", spacing));
  for (const char* title : {"uncertainty", "order", "extrapolated to 0", "remark"})
    page.header.emplace_back(title);
  for (const StudyRow& row : table.rows) {
    const GridConvergence& result = row.convergence;
    std::vector<std::string> cells{row.label};
    for (const auto& value : row.at) cells.push_back(study_value_text(value));
    cells.push_back(result.has_limit() ? number_text(result.uncertainty) : "-");
    cells.push_back(result.has_limit() && result.order > 0 ? fmt::format("{:.2f}", result.order)
                                                           : "-");
    cells.push_back(row.shows_limit() ? number_text(result.extrapolated) : "-");
    cells.push_back(row.remark);
    page.rows.push_back(std::move(cells));
  }
  return page;
}

PageTable runs_table(const std::vector<BatchRecord>& records) {
  PageTable page;
  page.caption = "Runs";
  page.header = {"folder",        "spacing [m]",  "particles",
                 "simulated [s]", "came to rest", "median particles in the depth",
                 "wall time [s]"};
  for (const BatchRecord& record : records) {
    page.rows.push_back({record.folder, fmt::format("{:g}", record.spacing),
                         fmt::format("{:.0f}", record.particles),
                         fmt::format("{:.1f}", record.simulated), record.at_rest ? "yes" : "no",
                         fmt::format("{:.1f}", record.median_layers),
                         fmt::format("{:.1f}", record.wall)});
  }
  return page;
}

std::vector<std::string> study_warnings(const std::vector<BatchRecord>& records,
                                        const StudyTable& table) {
  std::vector<std::string> warnings;
  for (std::size_t k = 1; k < table.spacings.size(); ++k) {
    const double coarse = table.spacings[k - 1], fine = table.spacings[k];
    if (coarse < least_ratio * fine)
      warnings.push_back(fmt::format(
          "{:g} and {:g} m are closer than a factor of {:g}: scatter may pass for an order", coarse,
          fine, least_ratio));
  }
  double fewest = std::numeric_limits<double>::infinity();
  for (const BatchRecord& record : records) fewest = std::min(fewest, record.median_layers);
  if (fewest < ResolutionGuard::enough_layers)
    warnings.push_back(fmt::format(
        "the coarsest flow is {:.1f} particles deep: below {:g} the error of a thin layer need not "
        "follow any order",
        fewest, ResolutionGuard::enough_layers));
  const auto moving = std::ranges::count(records, false, &BatchRecord::at_rest);
  if (moving > 0)
    warnings.push_back(
        fmt::format("{} of {} runs ended while the flow still moved: run-out and deposit are those "
                    "of that time",
                    moving, records.size()));
  return warnings;
}

}  // namespace sabo
