#include "post/compare_runs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "post/finished_run.hpp"
#include "post/map_difference.hpp"
#include "post/map_style.hpp"
#include "post/result_folder.hpp"
#include "post/run_plan.hpp"
#include "post/run_quantities.hpp"
#include "post/series_charts.hpp"
#include "post/table_text.hpp"
#include <fmt/format.h>

#include "base/version.hpp"
#include "io/gis/class_map.hpp"
#include "io/gis/write_raster.hpp"
#include "io/output/map_picture.hpp"
#include "io/output/qgis_style.hpp"
#include "run/tables.hpp"

namespace sabo {
namespace {

namespace fs = std::filesystem;

constexpr double same_end = 0.01;  // share of the time of the flow by which two ends may differ

PageTable quantity_table(const FinishedRun& a, const FinishedRun& b) {
  PageTable table{"Key quantities", {"quantity", "a", "b", "b - a", "change [%]"}, {}};
  for (const QuantityPair& pair : paired_quantities(a, b)) {
    const double change = pair.b - pair.a;
    table.rows.push_back({pair.label, table_number(pair.a, 9), table_number(pair.b, 9),
                          table_number(change, 9),
                          table_number(pair.a != 0 ? 100 * change / pair.a : std::nan(""), 4)});
  }
  return table;
}

/// The line of a map in the table of maps.
std::vector<std::string> map_row(const RunMap& a, const Raster& b, const DifferenceSummary& sum) {
  const double volume = a.name == "dep" ? sum.integral : std::nan("");
  return {fmt::format("{} [{}]", a.name, a.unit),
          table_number(greatest_value(a.raster)),
          table_number(greatest_value(b)),
          table_number(sum.greatest_rise),
          table_number(sum.greatest_fall),
          table_number(sum.mean_absolute),
          table_number(sum.area),
          std::isnan(volume) ? "-" : fmt::format("{:.3f}", std::round(1000 * volume) / 1000 + 0.0)};
}

/// Compares two runs and fills the folder of the result.
class RunComparison {
 public:
  RunComparison(const std::vector<FinishedRun>& runs, ResultFolder& folder)
      : a_(runs[0]),
        b_(runs[1]),
        names_(names_of(runs)),
        folder_(folder),
        ground_(runs[0].ground()),
        lines_(lines_of(runs)) {
    note_ends();
  }

  PostResult carry_out() {
    compare_footprints();
    for (const std::string& name : a_.maps())
      if (b_.has_map(name)) compare_map(name);
    for (const PairedChart& chart : paired_charts(a_, b_, names_))
      folder_.add_picture(chart.file, chart.svg, chart.caption, false);
    const PageTable quantities = quantity_table(a_, b_);
    folder_.write_table("quantities.csv", quantities);
    folder_.write_table("maps.csv", maps_);
    IndexPage page = page_head();
    page.tables = {quantities, maps_};
    PostResult result{folder_.write_page(std::move(page)), text_of(quantities)};
    for (const std::string& line : text_of(maps_)) result.summary.push_back(line);
    for (const std::string& note : notes_) result.summary.push_back("note: " + note);
    return result;
  }

 private:
  /// None, and a note, where the case of the run cannot be laid out any more.
  std::vector<MapLine> lines_of(const FinishedRun& run, const std::string& name) {
    RunPlan plan = plan_of(run);
    if (!plan.problem.empty())
      notes_.push_back(fmt::format("lines of {} are not drawn: {}", name, plan.problem));
    return std::move(plan.lines);
  }

  /// Lines of a, and those of the structures that only b has.
  std::vector<MapLine> lines_of(const std::vector<FinishedRun>& runs) {
    const std::vector<MapLine> of_a = lines_of(runs[0], names_[0]);
    std::vector<MapLine> lines = of_a;
    for (MapLine& line : lines_of(runs[1], names_[1])) {
      const auto is_there = [&](const MapLine& other) {
        return other.kind == line.kind && other.name_or_label() == line.name_or_label();
      };
      if (std::ranges::none_of(of_a, is_there)) lines.push_back(std::move(line));
    }
    return lines;
  }

  /// Deposits of two moments are no comparison of two cases.
  void note_ends() {
    const std::optional<double> a = a_.simulated(), b = b_.simulated();
    if (a && b && std::abs(*a - *b) > same_end * std::max(*a, *b))
      notes_.push_back(
          fmt::format("the runs end at different times, a at {:.1f} s and b at {:.1f} s", *a, *b));
  }

  Raster b_on_a(const RunMap& a) {
    AlignedMap other = aligned(b_.map(a.name), a);
    if (!other.note.empty())
      notes_.push_back(fmt::format("map {} of {} was {}", a.name, names_[1], other.note));
    return std::move(other.map.raster);
  }

  MapPicture picture(const std::string& title, const std::string& quantity) const {
    MapPicture map{title, a_.run_case().note, quantity, -infinity};
    map.view = view_;
    map.lines = lines_;
    return map;
  }

  /// Where only one of the two went, from the greatest depths.
  void compare_footprints() {
    const RunMap a = a_.map("pfd");
    const Raster b = b_on_a(a);
    const double wet_a = a_.wet_depth(), wet_b = b_.wet_depth();
    Raster reached(a.raster.grid, Raster::no_data);
    std::array<double, 4> areas{};
    for (std::size_t cell = 0; cell < reached.values.size(); ++cell) {
      const int which = (a.raster.values[cell] > wet_a ? 1 : 0) + (b.values[cell] > wet_b ? 2 : 0);
      areas[which] += reached.grid.cell_area();
      if (which > 0) reached.values[cell] = which;
    }
    view_ = view_around(reached, 0);
    MapPicture map = picture("Reached by the flow", "cells that were wet");
    const std::vector<RasterClass> classes{{1, "in a only", {230, 97, 1}},
                                           {2, "in b only", {94, 60, 153}},
                                           {3, "in both", {166, 206, 227}}};
    map.steps = class_steps(classes);
    folder_.add_picture("reached.svg", map_svg(map, ground_.raster, reached),
                        fmt::format("Wet in a only {} m2, in b only {} m2, in both {} m2 "
                                    "(maps/reached.tif; deeper than {:g} and {:g} m)",
                                    table_number(areas[1]), table_number(areas[2]),
                                    table_number(areas[3]), wet_a, wet_b),
                        true);
    write_class_raster(folder_.maps() / "reached.tif", reached, classes, a.crs_wkt,
                       "cells that were wet");
    folder_.write("maps/reached.qml", qgis_class_style(classes));
    folder_.list("maps/reached.tif", "1: wet in a only, 2: in b only, 3: in both");
  }

  void compare_map(const std::string& name) {
    const RunMap a = a_.map(name);
    const Raster b = b_on_a(a);
    const MapStyle style = style_of(a, std::min(a_.wet_depth(), b_.wet_depth()));
    const DifferenceSummary sum = summary_of(a.raster, b, style.threshold);
    maps_.rows.push_back(map_row(a, b, sum));

    const std::string file = fmt::format("diff_{}", name);
    RasterInfo info{a.crs_wkt, "difference b - a of: " + a.description, a.unit};
    info.metadata["run_a"] = names_[0];
    info.metadata["run_b"] = names_[1];
    write_raster(folder_.maps() / (file + ".tif"), difference(a.raster, b), info);
    const std::vector<ColourStep> steps = difference_steps(sum.scale);
    folder_.write(fmt::format("maps/{}.qml", file),
                  qgis_step_style("b - a, " + style.quantity, steps));
    folder_.list(fmt::format("maps/{}.tif", file), style.title + ", b - a, " + a.unit);

    MapPicture map = picture(style.title + ": b - a", "change of " + style.quantity);
    map.steps = steps;
    folder_.add_picture(
        file + ".svg", map_svg(map, ground_.raster, shown_difference(a.raster, b, style.threshold)),
        fmt::format("{}: {} (b) minus {} (a) (maps/{}.tif)", style.title, names_[1], names_[0],
                    file),
        true);
  }

  IndexPage page_head() const {
    IndexPage page;
    page.title = fmt::format("{} and {}", names_[0], names_[1]);
    page.subtitle = fmt::format("sabo {} · two runs compared", build_version);
    page.note = a_.run_case().note;
    page.facts = {{"a", fact_of(a_, names_[0])}, {"b", fact_of(b_, names_[1])}};
    page.remarks =
        "Differences are b - a. Mean change: of the magnitude, over the cells where either map is "
        "above its threshold. Volume: sum of the change of depth times the area of the cells.";
    for (const std::string& note : notes_)
      page.warning += (page.warning.empty() ? "" : "; ") + note;
    return page;
  }

  static std::string fact_of(const FinishedRun& run, const std::string& name) {
    return fmt::format("{}: {}, spacing {:g} m, {}, sabo {}", name,
                       run.run_case().title.empty() ? "no title" : run.run_case().title,
                       run.run_case().numerics.spacing, run.end(), run.version());
  }

  static constexpr double infinity = std::numeric_limits<double>::infinity();

  const FinishedRun& a_;
  const FinishedRun& b_;
  std::vector<std::string> names_;
  ResultFolder& folder_;
  RunMap ground_;
  std::vector<std::string> notes_;
  std::vector<MapLine> lines_;
  MapView view_;
  PageTable maps_{"Maps",
                  {"map", "greatest a", "greatest b", "greatest rise", "greatest fall",
                   "mean change", "area [m2]", "volume b - a [m3]"},
                  {}};
};

}  // namespace

PostResult compare_runs(const fs::path& a, const fs::path& b, const fs::path& output) {
  std::vector<FinishedRun> runs;
  runs.emplace_back(a);
  runs.emplace_back(b);
  for (const FinishedRun& run : runs) run.need_case();
  aligned(runs[1].ground(), runs[0].ground());  // whether they can be compared, before writing
  ResultFolder folder(output.empty() ? a / "compare" : output, "compare", {a, b});
  return RunComparison(runs, folder).carry_out();
}

}  // namespace sabo
