#include "report/report_maps.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>

#include "analysis/columns.hpp"

namespace sabo {
namespace {

constexpr double widest = 690, tallest = 620;  // px, so that two stand on a page of A4

MapPicture picture_of(Report& report, const MapStyle& style) {
  MapPicture map{style.title, "", style.quantity, style.threshold};
  map.steps = style.steps;
  map.lines = report.run.plan();
  map.contours = report.say("map.contours");
  map.has_coordinates = true;
  map.widest = widest;
  map.tallest = tallest;
  map.sharpness = report.sharpness;
  map.id = report.page.new_id();
  return map;
}

MapLine frame_of(const MapView& view) {
  return {MapLine::Kind::edit,
          "",
          {{{view.west, view.south, 0},
            {view.east, view.south, 0},
            {view.east, view.north, 0},
            {view.west, view.north, 0},
            {view.west, view.south, 0}},
           false}};
}

struct ScaleTop {
  double top = 0;
  double greatest = 0;
};

/// Where the colours should end when a few cells would take nearly all of them: at the value that
/// one cell in a hundred exceeds. Nothing when the greatest value is not far above it.
std::optional<ScaleTop> top_without_outliers(const Raster& raster, const MapStyle& style) {
  std::vector<double> values;
  for (const double value : raster.values)
    if (value > style.threshold) values.push_back(value);  // false for NaN
  if (values.size() < 100) return std::nullopt;
  const auto top = values.end() - static_cast<std::ptrdiff_t>(values.size() / 100) - 1;
  std::ranges::nth_element(values, top);
  const double greatest = *std::ranges::max_element(values);
  constexpr double far_above = 1.5;
  return greatest > far_above * *top ? std::optional(ScaleTop{*top, greatest}) : std::nullopt;
}

bool same_grid(const Raster& a, const Raster& b) { return a.grid == b.grid; }

}  // namespace

double wet_depth_of(const RunRecord& run) {
  return run.described() ? wet_depth(run.described()->numerics.spacing) : 0.05;
}

MapView view_of_flow(RunRecord& run) {
  const MapRecord* depth = run.map("pfd");
  if (depth) return view_around(depth->raster, wet_depth_of(run));
  const MapRecord* release = run.map("rel");
  return release ? view_around(release->raster, wet_depth_of(run)) : MapView{};
}

void add_map(Report& report, const std::string& name, const MapStyle& style) {
  const std::string file = "maps/" + name + ".tif";
  const MapRecord* ground = report.run.map("ground");
  const MapRecord* values = report.run.map(name);
  if (!ground || !values || !same_grid(ground->raster, values->raster)) {
    tell_missing(report, values ? "maps/ground.tif" : file);
    return;
  }
  MapPicture map = picture_of(report, style);
  map.view = view_of_flow(report.run);
  std::string source = data_line(report, {file});
  if (const auto top = top_without_outliers(values->raster, style); top && style.steps.empty()) {
    map.top = top->top;
    source = report.say("map.outliers", amount(top->top), amount(top->greatest)) + " " + source;
  }
  report.page.picture(map_svg(map, ground->raster, values->raster), source);
}

void add_location_map(Report& report) {
  const MapRecord* ground = report.run.map("ground");
  const MapRecord* release = report.run.map("rel");
  if (!ground) {
    tell_missing(report, "maps/ground.tif");
    return;
  }
  const Raster nothing(ground->raster.grid, Raster::no_data);
  const bool has_release = release && same_grid(ground->raster, release->raster);
  MapPicture map = picture_of(
      report, {report.say("site.map"), report.say("site.map_quantity"), wet_depth_of(report.run)});
  const Grid& grid = ground->raster.grid;
  map.view = {grid.west, grid.south(), grid.east(), grid.north};
  for (MapLine& line : map.lines) line.label.clear();
  map.lines.push_back(frame_of(view_of_flow(report.run)));
  map.tallest = 520;
  report.page.picture(map_svg(map, ground->raster, has_release ? release->raster : nothing),
                      data_line(report, {"maps/ground.tif", "maps/rel.tif", "maps/plan.geojson"}));
}

void add_map_key(Report& report) {
  std::vector<std::pair<MapLine::Kind, std::string>> entries;
  for (const auto& [kind, key] : {std::pair{MapLine::Kind::dam, "map.dam"},
                                  {MapLine::Kind::section, "map.section"},
                                  {MapLine::Kind::inflow, "map.inflow"},
                                  {MapLine::Kind::path, "map.path"},
                                  {MapLine::Kind::zone, "map.zone"}}) {
    const MapLine::Kind wanted = kind;
    const bool is_there = std::ranges::any_of(
        report.run.plan(), [wanted](const MapLine& line) { return line.kind == wanted; });
    if (is_there) entries.emplace_back(kind, report.say(key));
  }
  entries.emplace_back(MapLine::Kind::edit, report.say("map.frame"));
  report.page.key(entries);
}

}  // namespace sabo
