#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "report/html_page.hpp"
#include "report/phrases.hpp"
#include "report/run_record.hpp"

namespace sabo {

/// What every section of the report is written from and to.
struct Report {
  RunRecord& run;
  RunRecord* other;  ///< run to compare with, or nullptr
  const Phrases& say;
  HtmlPage& page;
  double sharpness = 2;  ///< of maps, pixels for one px of the page
};

// The sections in the order of the report. Each reads what it needs and says what is missing.
void add_summary(Report& report);
void add_site(Report& report);
void add_release(Report& report);
void add_inflows(Report& report);
void add_parameters(Report& report);
void add_structures(Report& report);
void add_maps(Report& report);
void add_profile(Report& report);
void add_hydrographs(Report& report);
void add_gauges(Report& report);
void add_front(Report& report);
void add_balance(Report& report);
void add_loads(Report& report);
void add_zones(Report& report);
void add_comparison(Report& report);
void add_hazard(Report& report);
void add_resolution(Report& report);
void add_ledger(Report& report);
void add_limits(Report& report);
void add_inputs(Report& report);
void add_files(Report& report);

// What they share.

/// "Data: series/front.csv", with what to look for there.
std::string data_line(const Report& report, std::initializer_list<std::string_view> files);

/// Whether particles resolve the flow, by its median greatest depth (particles); says nothing of a
/// flow that they do unless `praises`.
void tell_resolution(Report& report, double median, bool praises);

/// Says that a section has nothing to show for want of a file.
void tell_missing(Report& report, const std::string& file);

/// A number to three digits that matter, or whole from 100 on; a true minus sign.
std::string amount(double value);
/// With a fixed number of decimals.
std::string fixed(double value, int decimals);
/// A share as percent.
std::string percent(double share, int decimals = 0);
/// A number that may not be there, "–" without it.
std::string amount_or_dash(const std::optional<double>& value);

/// With raised digits: "kg/m³" of "kg/m3", "volume [m³]" of "volume [m3]".
std::string shown_unit(std::string text);

/// A file of the user as a report names it that is handed on: without the folders of their machine.
/// Any other text as it is.
std::string shown_file(const std::string& path);

/// The number in a field of a table; NaN where it is none.
double number_of_field(const std::string& field);

struct Peak {
  double value = 0;
  double time = 0;  ///< s
};
/// The value of a column that is greatest without its sign; nothing without finite values.
std::optional<Peak> peak_of(const NumberTable& table, const std::string& column);

/// What stands before `suffix` in the names of columns, in their order.
std::vector<std::string> names_before(const NumberTable& table, std::string_view suffix);

/// A column over time; empty without it.
ChartSeries over_time(const NumberTable& table, const std::string& column, const std::string& name,
                      double scale = 1);

/// The case's title, or the name of the folder.
std::string title_of(const RunRecord& run);

}  // namespace sabo
