#include "post/compare_observed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "post/finished_run.hpp"
#include "post/map_difference.hpp"
#include "post/map_style.hpp"
#include "post/observed_data.hpp"
#include "post/result_folder.hpp"
#include "post/run_plan.hpp"
#include "post/table_text.hpp"
#include <fmt/format.h>

#include "analysis/footprint_score.hpp"
#include "analysis/run_out.hpp"
#include "base/version.hpp"
#include "io/gis/class_map.hpp"
#include "io/gis/write_raster.hpp"
#include "io/output/map_picture.hpp"
#include "io/output/qgis_style.hpp"
#include "run/tables.hpp"
#include "terrain/cells_within.hpp"

namespace sabo {
namespace {

namespace fs = std::filesystem;

const std::vector<RasterClass>& footprint_classes() {
  static const std::vector<RasterClass> classes{
      {1, "hit", {0, 114, 178}}, {2, "miss", {213, 94, 0}}, {3, "false alarm", {240, 228, 66}}};
  return classes;
}

constexpr const char* remarks =
    "Hit: reached in both; miss: in the survey only; false alarm: in the run only. Critical "
    "success index: hit / (hit + miss + false alarm), which of areas is also intersection over "
    "union (Jaccard). Precision: hit / simulated; recall: hit / observed; area ratio: simulated / "
    "observed (Jolliffe & Stephenson 2012, Forecast Verification, chapter 3). Omega = alpha - "
    "beta - gamma with hit, false alarm and miss over the observed area (Scheidl & Rickenmann "
    "2010). Depth errors are simulated minus observed over the cells that were hit. Run-out: "
    "station along the path of the farthest cell that was reached.";

/// Sets one run beside a survey and fills the folder of the result.
class Survey {
 public:
  Survey(const FinishedRun& run, ObservedCase observed, ObservedData data, ResultFolder& folder)
      : run_(run),
        observed_(std::move(observed)),
        folder_(folder),
        plan_(plan_of(run)),
        data_(std::move(data)) {
    if (!plan_.problem.empty())
      notes_.push_back("path, zones and lines of the case are left out: " + plan_.problem);
  }

  PostResult carry_out() {
    if (observed_.has_footprint()) compare_footprint();
    if (!observed_.arrivals.empty()) tables_.push_back(arrival_table());
    IndexPage page;
    page.title = fmt::format("{} and {}", run_.name(), observed_.source);
    page.subtitle = fmt::format("sabo {} · a run beside a survey", build_version);
    page.note = run_.run_case().note;
    page.tables = tables_;
    if (observed_.has_footprint()) page.remarks = remarks;
    PostResult result;
    for (const PageTable& table : tables_)
      for (const std::string& line : text_of(table)) result.summary.push_back(line);
    for (const std::string& note : notes_) {
      page.warning += (page.warning.empty() ? "" : "; ") + note;
      result.summary.push_back("note: " + note);
    }
    result.index = folder_.write_page(std::move(page));
    return result;
  }

 private:
  void add_table(const std::string& file, PageTable table) {
    folder_.write_table(file, table);
    tables_.push_back(std::move(table));
  }

  void compare_footprint() {
    notes_.insert(notes_.end(), data_.notes.begin(), data_.notes.end());
    const FootprintPair pair{data_.simulated.raster, data_.observed, data_.wet,
                             data_.observed_wet()};
    add_table("scores.csv", score_table(pair));
    if (!plan_.zones.empty()) add_table("zones.csv", zone_table(pair));
    write_footprint(pair);
    if (data_.has_depths) write_depth_error(pair);
  }

  PageTable score_table(const FootprintPair& pair) const {
    const FootprintScore score = footprint_score(pair, data_.cells);
    PageTable table{"Footprint", {"quantity", "value", "unit"}, {}};
    const auto add = [&](const char* name, double value, const char* unit, int digits = 6) {
      table.rows.push_back({name, table_number(value, digits), unit});
    };
    add("observed area", score.observed(), "m2");
    add("simulated area", score.simulated(), "m2");
    add("hit", score.hit, "m2");
    add("miss", score.miss, "m2");
    add("false alarm", score.false_alarm, "m2");
    add("critical success index = intersection over union", score.csi(), "", 4);
    add("precision", score.precision(), "", 4);
    add("recall", score.recall(), "", 4);
    add("area ratio", score.bias(), "", 4);
    add("Omega", score.omega(), "", 4);
    add("depth above which a cell counts", data_.wet, "m");
    if (data_.has_depths) add_depths(pair, table);
    add_places(pair, table);
    return table;
  }

  void add_depths(const FootprintPair& pair, PageTable& table) const {
    const DepthError error = depth_error(pair, data_.cells);
    double observed = 0, simulated = 0;
    for (const std::size_t cell : data_.cells) {
      observed += pair.observed.values[cell] * pair.observed.grid.cell_area();
      simulated += pair.simulated.values[cell] * pair.observed.grid.cell_area();
    }
    const auto add = [&](const char* name, double value, const char* unit) {
      table.rows.push_back({name, table_number(value), unit});
    };
    add("observed volume", observed, "m3");
    add("simulated volume", simulated, "m3");
    add("mean depth error where hit", error.mean, "m");
    add("mean absolute depth error where hit", error.mean_absolute, "m");
    add("root mean square depth error where hit", error.root_mean_square, "m");
  }

  void add_places(const FootprintPair& pair, PageTable& table) const {
    std::vector<std::size_t> simulated, observed;
    for (const std::size_t cell : data_.cells) {
      const FootprintCell what = pair.at(cell);
      if (what == FootprintCell::hit || what == FootprintCell::false_alarm)
        simulated.push_back(cell);
      if (what == FootprintCell::hit || what == FootprintCell::miss) observed.push_back(cell);
    }
    if (plan_.path.vertices.size() < 2) return;
    const auto run = place_of(pair.simulated.grid, simulated, plan_.path);
    const auto survey = place_of(pair.simulated.grid, observed, plan_.path);
    if (!run || !survey) return;
    const auto add = [&](const char* name, double value) {
      table.rows.push_back({name, table_number(value), "m"});
    };
    const LinePlace a = project(plan_.path, survey->centroid_x, survey->centroid_y);
    const LinePlace b = project(plan_.path, run->centroid_x, run->centroid_y);
    add("observed run-out along the path", survey->station);
    add("simulated run-out along the path", run->station);
    add("run-out error", run->station - survey->station);
    add("centroid error along the path", b.station - a.station);
    add("centroid error to the left of the path", b.offset - a.offset);
    add("distance between the centroids",
        std::hypot(run->centroid_x - survey->centroid_x, run->centroid_y - survey->centroid_y));
  }

  /// Cells of a zone that are compared.
  std::vector<std::size_t> cells_of(const NamedZone& zone) const {
    std::vector<char> is_compared(data_.observed.values.size(), 0);
    for (const std::size_t cell : data_.cells) is_compared[cell] = 1;
    std::vector<std::size_t> cells = cells_within(data_.observed.grid, zone.polygons);
    std::erase_if(cells, [&](std::size_t cell) { return !is_compared[cell]; });
    return cells;
  }

  PageTable zone_table(const FootprintPair& pair) const {
    PageTable table{"By zone", {"zone", "hit [m2]", "miss [m2]", "false alarm [m2]", "CSI"}, {}};
    if (data_.has_depths)
      for (const char* title : {"mean observed depth [m]", "mean simulated depth [m]",
                                "depth error where hit [m]", "RMS error where hit [m]"})
        table.header.emplace_back(title);
    for (const NamedZone& zone : plan_.zones) {
      const std::vector<std::size_t> cells = cells_of(zone);
      const FootprintScore score = footprint_score(pair, cells);
      std::vector<std::string> row{zone.name, table_number(score.hit), table_number(score.miss),
                                   table_number(score.false_alarm), table_number(score.csi(), 4)};
      if (data_.has_depths) {
        const DepthError error = depth_error(pair, cells);
        const auto mean = [&](const Raster& raster) {
          double sum = 0;
          for (const std::size_t cell : cells) sum += raster.values[cell];
          return sum / static_cast<double>(cells.size());
        };
        const double none = error.area > 0 ? 1 : std::nan("");
        for (const double value : {mean(pair.observed), mean(pair.simulated), none * error.mean,
                                   none * error.root_mean_square})
          row.push_back(table_number(value, 4));
      }
      table.rows.push_back(std::move(row));
    }
    return table;
  }

  PageTable arrival_table() {
    const RunMap arrival = run_.map("tarr");
    PageTable table{"Arrival", {"place", "observed [s]", "simulated [s]", "error [s]"}, {}};
    double squares = 0;
    int count = 0;
    for (const ObservedArrivalCase& place : observed_.arrivals) {
      const auto time = arrival_at(arrival.raster, place.place[0], place.place[1]);
      const double error = time ? *time - place.time : std::nan("");
      if (time) squares += error * error, ++count;
      table.rows.push_back({place.name, table_number(place.time),
                            time ? table_number(*time) : "never", table_number(error)});
    }
    if (count > 1)
      table.rows.push_back({"root mean square", "", "", table_number(std::sqrt(squares / count))});
    folder_.write_table("arrival.csv", table);
    return table;
  }

  MapPicture picture(const std::string& title, const std::string& quantity) const {
    MapPicture map{title, run_.run_case().note, quantity, -infinity};
    map.view = view_;
    map.lines = plan_.lines;
    return map;
  }

  void write_footprint(const FootprintPair& pair) {
    Raster cells(pair.observed.grid, Raster::no_data);
    for (const std::size_t cell : data_.cells) {
      const FootprintCell what = pair.at(cell);
      if (what != FootprintCell::dry) cells.values[cell] = static_cast<double>(what);
    }
    view_ = view_around(cells, 0);
    write_class_raster(folder_.maps() / "footprint.tif", cells, footprint_classes(),
                       data_.simulated.crs_wkt, "footprint of the run and of the survey");
    folder_.write("maps/footprint.qml", qgis_class_style(footprint_classes()));
    folder_.list("maps/footprint.tif", "1: hit, 2: miss, 3: false alarm");
    MapPicture map = picture("Run and survey", "cells deeper than the threshold");
    map.steps = class_steps(footprint_classes());
    folder_.add_picture("footprint.svg", map_svg(map, run_.ground().raster, cells),
                        fmt::format("{}; {} beside the survey (maps/footprint.tif)",
                                    observed_.source, data_.simulated.description),
                        true);
  }

  /// Outside of the surveyed area nothing is compared.
  Raster surveyed(const Raster& all) const {
    Raster part = all;
    part.values.assign(all.values.size(), Raster::no_data);
    for (const std::size_t cell : data_.cells) part.values[cell] = all.values[cell];
    return part;
  }

  void write_depth_error(const FootprintPair& pair) {
    const double least = std::min(data_.wet, data_.observed_wet());
    const Raster observed = surveyed(pair.observed), simulated = surveyed(pair.simulated);
    const DifferenceSummary sum = summary_of(observed, simulated, least);
    write_raster(folder_.maps() / "depth_error.tif", difference(observed, simulated),
                 {data_.simulated.crs_wkt, "simulated minus observed depth", "m"});
    const std::vector<ColourStep> steps = difference_steps(sum.scale);
    folder_.write("maps/depth_error.qml", qgis_step_style("depth error [m]", steps));
    folder_.list("maps/depth_error.tif", "simulated minus observed depth, m");
    MapPicture map = picture("Depth: run minus survey", "depth error [m]");
    map.steps = steps;
    folder_.add_picture(
        "depth_error.svg",
        map_svg(map, run_.ground().raster, shown_difference(observed, simulated, least)),
        "Simulated minus observed depth (maps/depth_error.tif)", true);
  }

  static constexpr double infinity = std::numeric_limits<double>::infinity();

  const FinishedRun& run_;
  ObservedCase observed_;
  ResultFolder& folder_;
  RunPlan plan_;
  ObservedData data_;
  MapView view_;
  std::vector<PageTable> tables_;
  std::vector<std::string> notes_;
};

}  // namespace

PostResult compare_observed(const fs::path& run, const ObservedOptions& options,
                            const fs::path& output) {
  const FinishedRun finished(run);
  finished.need_case();
  ObservedCase observed = observed_case(finished, options);
  ObservedData data;
  if (observed.has_footprint()) data = read_observed(finished, observed);
  ResultFolder folder(output.empty() ? run / "observed" : output, "observed", {run});
  return Survey(finished, std::move(observed), std::move(data), folder).carry_out();
}

}  // namespace sabo
