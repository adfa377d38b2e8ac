#include "post/export_run.hpp"

#include <algorithm>
#include <cmath>
#include <system_error>

#include "post/finished_run.hpp"
#include "post/map_style.hpp"
#include "post/result_folder.hpp"
#include "post/run_plan.hpp"
#include <fmt/format.h>

#include "base/error.hpp"
#include "io/case_file/key_text.hpp"
#include "io/gis/class_map.hpp"
#include "io/gis/write_ascii_grid.hpp"
#include "io/gis/write_layers.hpp"
#include "io/gis/write_raster.hpp"
#include "io/output/file.hpp"
#include "io/output/qgis_style.hpp"

namespace sabo {
namespace {

namespace fs = std::filesystem;

/// Cells of a map above each depth as polygons.
VectorLayer outlines(const std::string& name, const RunMap& map,
                     const std::vector<double>& depths) {
  VectorLayer layer{name, {{"deeper_than_m", true}, {"area_m2", true}}};
  for (const double depth : depths) {
    Raster cells(map.raster.grid, Raster::no_data);
    for (std::size_t cell = 0; cell < cells.values.size(); ++cell)
      if (map.raster.values[cell] > depth) cells.values[cell] = 1;
    for (ClassPolygon& one : polygons_of(cells)) {
      const double size = area(one.polygon);
      layer.rows.push_back({std::move(one.polygon), {depth, size}});
    }
  }
  return layer;
}

/// What stands on the map, a layer for each kind of line.
std::vector<VectorLayer> plan_layers(const RunPlan& plan) {
  const std::vector<LayerField> fields{{"name", false}};
  VectorLayer structures{"structures", fields}, inflows{"inflows", fields},
      sections{"sections", fields}, path{"path", fields}, zones{"zones", fields};
  for (const MapLine& line : plan.structures)
    structures.rows.push_back({line.line, {line.name_or_label()}});
  for (const MapLine& line : plan.inflows) inflows.rows.push_back({line.line, {line.label}});
  for (const NamedSection& section : plan.sections)
    sections.rows.push_back({section.line, {section.name}});
  for (const NamedZone& zone : plan.zones)
    for (const Polygon& polygon : zone.polygons) zones.rows.push_back({polygon, {zone.name}});
  if (plan.path.vertices.size() > 1) path.rows.push_back({plan.path, {std::string("path")}});
  return {structures, inflows, sections, path, zones};
}

std::string style_text(const RunMap& map, double wet_depth) {
  if (map.name == "ground") return qgis_ground_style();
  const MapStyle style = style_of(map, wet_depth);
  if (!style.steps.empty()) return qgis_step_style(style.quantity, style.steps);
  const double top = greatest_value(map.raster);
  return qgis_flow_style(style.quantity, style.threshold, top > 0 ? top : 1);
}

std::vector<std::string> checked_formats(const ExportOptions& options) {
  const std::vector<std::string> known = export_formats();
  for (const std::string& format : options.formats)
    if (std::ranges::find(known, format) == known.end())
      throw CaseError("--format", fmt::format("\"{}\" is not known", format),
                      "give " + words_text(known));
  for (const double depth : options.depths)
    if (!(depth >= 0 && std::isfinite(depth)))
      throw CaseError("--depths", fmt::format("{} is not a depth", depth),
                      "give metres, 0 or more");
  return options.formats.empty() ? known : options.formats;
}

/// Writes one run in the wanted formats.
class RunExport {
 public:
  RunExport(const FinishedRun& run, const ResultFolder& folder, std::vector<std::string> formats)
      : run_(run), folder_(folder), formats_(std::move(formats)) {}

  std::vector<std::string> carry_out(const std::vector<double>& depths) {
    remove_former();
    if (has("ascii")) make_folder(ascii_);
    std::vector<std::string> names = run_.maps();
    names.emplace_back("ground");
    for (const std::string& name : names) write_map(run_.map(name));
    if (has("ascii"))
      lines_.push_back(fmt::format("{} ESRI ASCII grids in {}", names.size(), ascii_.string()));
    if (has("qgis"))
      lines_.push_back(
          fmt::format("{} GeoTIFFs with QGIS styles in {}", names.size(), folder_.maps().string()));
    if (has("gpkg")) write_vectors(depths);
    return lines_;
  }

 private:
  bool has(const char* format) const {
    return std::ranges::find(formats_, format) != formats_.end();
  }

  /// Of an export of another run or with other formats.
  void remove_former() const {
    std::error_code error;
    for (const fs::path& former : {ascii_, vectors_}) fs::remove_all(former, error);
  }

  void write_map(const RunMap& map) {
    if (has("ascii")) write_ascii_grid(ascii_ / (map.name + ".asc"), map.raster, map.crs_wkt);
    if (!has("qgis")) return;
    write_raster(folder_.maps() / (map.name + ".tif"), map.raster,
                 {map.crs_wkt, map.description, map.unit});
    folder_.write(fmt::format("maps/{}.qml", map.name), style_text(map, run_.wet_depth()));
  }

  void write_vectors(const std::vector<double>& depths) {
    const RunPlan plan = plan_of(run_);
    if (!plan.problem.empty())
      lines_.push_back("note: structures, inflows, sections, path and zones are left out: " +
                       plan.problem);
    std::vector<VectorLayer> layers = plan_layers(plan);
    const RunMap peak = run_.map("pfd");
    layers.push_back(outlines("affected_area", peak, depths));
    layers.push_back(outlines("deposit_area", run_.map("dep"), depths));
    write_layers(vectors_, layers, peak.crs_wkt);
    std::string names;
    for (const VectorLayer& layer : layers)
      if (!layer.rows.empty()) names += (names.empty() ? "" : ", ") + layer.name;
    lines_.push_back(fmt::format("{}: {}", vectors_.string(), names));
  }

  const FinishedRun& run_;
  const ResultFolder& folder_;
  const fs::path ascii_ = folder_.root() / "ascii", vectors_ = folder_.root() / "vectors.gpkg";
  std::vector<std::string> formats_;
  std::vector<std::string> lines_;
};

}  // namespace

std::vector<std::string> export_formats() { return {"ascii", "gpkg", "qgis"}; }

std::vector<std::string> export_run(const ExportOptions& options) {
  std::vector<std::string> formats = checked_formats(options);
  const FinishedRun run(options.run);
  const ResultFolder folder(options.output.empty() ? options.run / "export" : options.output,
                            "export", {options.run});
  return RunExport(run, folder, std::move(formats)).carry_out(options.depths);
}

}  // namespace sabo
