#include "post/hazard.hpp"

#include <algorithm>
#include <cmath>
#include <system_error>

#include "post/finished_run.hpp"
#include "post/map_difference.hpp"
#include "post/map_style.hpp"
#include "post/result_folder.hpp"
#include "post/run_plan.hpp"
#include "post/table_text.hpp"
#include <fmt/format.h>

#include "analysis/hazard_map.hpp"
#include "base/counted.hpp"
#include "base/error.hpp"
#include "base/version.hpp"
#include "io/case_file/key_text.hpp"
#include "io/case_file/read_hazard_rules.hpp"
#include "io/case_file/text_check.hpp"
#include "io/gis/class_map.hpp"
#include "io/gis/write_layers.hpp"
#include "io/output/map_picture.hpp"
#include "io/output/qgis_style.hpp"
#include "io/output/read_file.hpp"
#include "run/tables.hpp"

namespace sabo {
namespace {

namespace fs = std::filesystem;

/// The map that holds a quantity.
const char* map_of(HazardQuantity quantity) {
  switch (quantity) {
    case HazardQuantity::deposit:
      return "dep";
    case HazardQuantity::speed:
    case HazardQuantity::impact:
      return "pfv";
    case HazardQuantity::momentum_flux:
      return "pmf";
    case HazardQuantity::pressure:
      return "ppr";
    default:
      return "pfd";
  }
}

std::vector<RasterClass> raster_classes(const std::vector<HazardClass>& classes) {
  std::vector<RasterClass> named;
  for (std::size_t k = 0; k < classes.size(); ++k)
    named.push_back({static_cast<int>(classes.size() - k), classes[k].label, classes[k].colour});
  return named;
}

class HazardStudy {
 public:
  HazardStudy(const HazardRules& rules, const std::vector<FinishedRun>& runs,
              const std::vector<double>& periods)
      : rules_(rules), runs_(runs), names_(names_of(runs)), periods_(periods) {
    for (std::size_t k = 0; k < runs.size(); ++k) {
      const Raster classes = classes_of(k);
      if (k == 0) worst_ = Raster(classes.grid, Raster::no_data);
      take_worse(classes, worst_);
      if (periods_.empty()) continue;
      if (k == 0) levels_ = Raster(classes.grid, Raster::no_data);
      take_worse(levels_of(classes, rules_, periods_[k]), levels_);
    }
  }

  PostResult write(ResultFolder& folder) {
    RunPlan plan = plan_of(runs_.front());
    if (!plan.problem.empty()) notes_.push_back("lines of the case are not drawn: " + plan.problem);
    lines_ = std::move(plan.lines);
    view_ = view_around(worst_, 0);
    if (!periods_.empty()) write_map("levels", "level of hazard", rules_.levels, levels_, folder);
    write_map("classes", "classes", rules_.classes, worst_, folder);

    IndexPage page;
    page.title = rules_.name;
    page.subtitle =
        fmt::format("sabo {} · classes of {}", build_version, counted(runs_.size(), "run"));
    page.note = runs_.front().run_case().note;
    page.warning = rules_.caution;
    for (std::size_t k = 0; k < runs_.size(); ++k) page.facts.emplace_back("Run", run_text(k));
    page.tables = tables_;
    page.remarks = "Rules: " + rules_.source;
    for (const std::string& note : notes_) page.remarks += "; " + note;
    PostResult result;
    for (const PageTable& table : tables_)
      for (const std::string& line : text_of(table)) result.summary.push_back(line);
    for (const std::string& note : notes_) result.summary.push_back("note: " + note);
    if (!rules_.caution.empty()) result.summary.push_back("caution: " + rules_.caution);
    result.index = folder.write_page(std::move(page));
    return result;
  }

 private:
  std::string run_text(std::size_t k) const {
    if (periods_.empty()) return names_[k];
    return fmt::format("{}, return period {:g} years", names_[k], periods_[k]);
  }

  /// A quantity of a run on the grid of the first run.
  Raster values_of(std::size_t run, HazardQuantity quantity) {
    const char* name = map_of(quantity);
    if (!runs_[run].has_map(name))
      throw CaseError(
          runs_[run].folder().string(),
          fmt::format("has no map {}.tif, which the rules look at ({})", name, word_of(quantity)),
          "run the case again, or change the rules");
    RunMap map = runs_[run].map(name);
    if (run > 0) {
      AlignedMap other = aligned(std::move(map), runs_[0].ground());
      if (!other.note.empty())
        notes_.push_back(fmt::format("map {} of {} was {}", name, names_[run], other.note));
      map = std::move(other.map);
    }
    if (quantity == HazardQuantity::impact) {
      const double density = runs_[run].run_case().material.density;
      for (double& value : map.raster.values) value = density * value * value / 1000;  // kPa
    }
    return std::move(map.raster);
  }

  Raster classes_of(std::size_t run) {
    HazardMaps maps;
    for (const HazardQuantity quantity : quantities_of(rules_))
      maps.emplace(quantity, values_of(run, quantity));
    const double wet = rules_.wet_depth > 0 ? rules_.wet_depth : runs_[run].wet_depth();
    return classify(rules_, maps, wet);
  }

  void write_map(const std::string& file, const std::string& title,
                 const std::vector<HazardClass>& classes, const Raster& numbers,
                 ResultFolder& folder) {
    const std::vector<RasterClass> named = raster_classes(classes);
    const RunMap ground = runs_.front().ground();
    write_class_raster(folder.maps() / (file + ".tif"), numbers, named, ground.crs_wkt,
                       fmt::format("{}: {}", rules_.name, title));
    folder.write(fmt::format("maps/{}.qml", file), qgis_class_style(named));
    folder.list(fmt::format("maps/{}.tif", file), title + ", the greater number the worse");
    write_outlines(file, classes, numbers, ground.crs_wkt, folder);
    add_areas(file, title, named, numbers, folder);

    MapPicture map{fmt::format("{}: {}", rules_.name, title), runs_.front().run_case().note, title};
    map.view = view_;
    map.lines = lines_;
    map.steps = class_steps(named);
    folder.add_picture(
        file + ".svg", map_svg(map, ground.raster, numbers),
        fmt::format("{}: {}, the worst over the runs (maps/{}.tif)", rules_.name, title, file),
        true);
  }

  static void write_outlines(const std::string& file, const std::vector<HazardClass>& classes,
                             const Raster& numbers, const std::string& crs, ResultFolder& folder) {
    VectorLayer layer{file,
                      {{"number", true},
                       {"class", false},
                       {"label", false},
                       {"colour", false},
                       {"area_m2", true}},
                      {}};
    for (ClassPolygon& one : polygons_of(numbers)) {
      const HazardClass& of = classes[classes.size() - static_cast<std::size_t>(one.number)];
      const double size = area(one.polygon);
      layer.rows.push_back(
          {std::move(one.polygon),
           {static_cast<double>(one.number), of.name, of.label, hex(of.colour), size}});
    }
    if (layer.rows.empty()) return;
    write_layers(folder.maps() / (file + ".gpkg"), {layer}, crs);
    folder.list(fmt::format("maps/{}.gpkg", file), "their outlines");
  }

  void add_areas(const std::string& file, const std::string& title,
                 const std::vector<RasterClass>& classes, const Raster& numbers,
                 ResultFolder& folder) {
    PageTable table{"Areas: " + title, {"class", "number", "area [m2]"}, {}};
    for (const RasterClass& one : classes) {
      const auto cells = std::ranges::count(numbers.values, static_cast<double>(one.number));
      table.rows.push_back(
          {one.label, std::to_string(one.number),
           table_number(static_cast<double>(cells) * numbers.grid.cell_area(), 9)});
    }
    folder.write_table(file + ".csv", table);
    tables_.push_back(std::move(table));
  }

  const HazardRules& rules_;
  const std::vector<FinishedRun>& runs_;
  std::vector<std::string> names_;
  const std::vector<double>& periods_;
  Raster worst_, levels_;
  std::vector<MapLine> lines_;
  MapView view_;
  std::vector<PageTable> tables_;
  std::vector<std::string> notes_;
};

void check_periods(const HazardOptions& options, const HazardRules& rules) {
  if (options.return_periods.empty()) return;
  if (!rules.matrix)
    throw CaseError("--periods", fmt::format("the rules \"{}\" have no matrix", rules.name),
                    "leave out --periods, or add [matrix] to the rules");
  if (options.return_periods.size() != options.runs.size())
    throw CaseError(
        "--periods",
        fmt::format("{} for {}", counted(options.return_periods.size(), "return period"),
                    counted(options.runs.size(), "run")),
        "give one for each run, in their order");
  for (const double years : options.return_periods)
    if (!(years > 0 && std::isfinite(years)))
      throw CaseError("--periods", fmt::format("{} is no return period", years),
                      "give years above 0");
}

/// By another name too.
void refuse_twice(const std::vector<fs::path>& runs) {
  for (std::size_t b = 1; b < runs.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      std::error_code error;
      if (fs::equivalent(runs[a], runs[b], error))
        throw CaseError(runs[b].string(), "is given twice", "name each run once");
    }
  }
}

}  // namespace

std::string hazard_rules_of(const std::string& name) {
  if (const std::string_view known = hazard_rules_text(name); !known.empty())
    return std::string(known);
  const auto text = read_file(name, largest_text);
  if (text) {
    Faults faults;
    read_hazard_rules(*text, name, faults);
    faults.throw_if_any();
    return *text;
  }
  throw CaseError("--rules", fmt::format("\"{}\" is neither rules of the program nor a file", name),
                  "give " + words_text(known_hazard_rules()) + ", or a file");
}

PostResult hazard_maps(const HazardOptions& options) {
  const std::string text = hazard_rules_of(options.rules);
  Faults faults;
  const HazardRules rules = read_hazard_rules(text, options.rules, faults);
  faults.throw_if_any();
  check_periods(options, rules);
  refuse_twice(options.runs);
  std::vector<FinishedRun> runs;
  for (const fs::path& run : options.runs) runs.emplace_back(run).need_case();
  HazardStudy study(rules, runs, options.return_periods);
  ResultFolder folder(options.output.empty() ? options.runs.front() / "hazard" : options.output,
                      "hazard", options.runs);
  folder.write("rules.toml", text);
  folder.list("rules.toml", "the rules, to be changed and used again with --rules");
  return study.write(folder);
}

}  // namespace sabo
