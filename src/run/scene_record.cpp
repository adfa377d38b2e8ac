#include "run/scene_record.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "analysis/columns.hpp"
#include "io/case_file/toml_string.hpp"
#include "io/case_file/write_case.hpp"
#include "io/gis/write_raster.hpp"
#include "io/output/file.hpp"
#include "io/output/plan_file.hpp"
#include "run/overlay.hpp"
#include "run/scene_lines.hpp"

namespace sabo {
namespace {

void write_map(const std::filesystem::path& file, Raster raster, const std::string& what,
               const std::string& note, const Frame& frame) {
  RasterInfo info{frame.crs, what, "m"};
  if (!note.empty()) info.metadata["note"] = note;
  write_raster(file, in_crs(std::move(raster), frame), info);
}

/// Vertical depth of the release over the cells of the DEM, m, in the solver frame.
Raster release_depth(const Case& c, const Scene& scene) {
  Columns columns(scene.surface->elevation(), c.numerics.spacing, c.material.density);
  columns.update(scene.release);
  return columns.depth();
}

/// In the coordinates of the DEM, a dam with the elevation of its crest.
std::vector<MapLine> plan_lines(const Scene& scene) {
  std::vector<MapLine> lines = overlay(scene, DamLine::whole);
  for (MapLine& line : lines)
    for (Vec3d& vertex : line.line.vertices) vertex += scene.frame.origin();
  for (const CheckDam& dam : scene.dams) {
    const auto line = std::ranges::find_if(lines, [&](const MapLine& candidate) {
      return candidate.kind == MapLine::Kind::dam && candidate.label == dam.name;
    });
    if (line == lines.end() || dam.axis.has_z) continue;
    line->line = {{}, true};
    for (const double station : dam_stations(dam)) {
      const Vec3d at = point_at(dam.axis, station);
      line->line.vertices.push_back(
          {at.x + scene.frame.origin_x, at.y + scene.frame.origin_y, dam.crest_at(station)});
    }
  }
  return lines;
}

std::string edit_text(const TerrainEditCase& c, const EditReport& report) {
  return fmt::format(
      "\n[[edit]]\nedit = {}\nkind = {}\ncells = {}\ncut = {:.3f}\nfill = {:.3f}\n"
      "greatest_change = {:.3f}\n",
      toml_string(report.name), toml_string(std::string(word_of(c.kind))), report.cells, report.cut,
      report.fill, report.greatest);
}

}  // namespace

void write_scene_record(const Case& c, const Scene& scene, const RunFolder& folder) {
  write_file_atomically(folder.root() / "case.toml", write_case(c));
  write_plan(folder.maps() / "plan.geojson", plan_lines(scene), scene.frame.crs);
  write_map(folder.maps() / "ground.tif", scene.surface->elevation(),
            "elevation of the ground as the run used it", c.note, scene.frame);
  write_map(folder.maps() / "rel.tif", release_depth(c, scene), "vertical depth of the release",
            c.note, scene.frame);
}

std::string scene_toml(const Case& c, const Scene& scene) {
  const double area = scene.release_area;
  std::string notes;
  for (const std::string& note : scene.dem_notes)
    notes += (notes.empty() ? "" : ", ") + toml_string(note);
  std::string text = fmt::format(
      "\n[terrain]\nholes_filled = {}\ncells_filled = {}\nholes_left = {}\nnotes = [{}]\n",
      scene.holes.holes_filled, scene.holes.cells_filled, scene.holes.holes_left, notes);
  for (std::size_t k = 0; k < scene.edits.size() && k < c.terrain.edits.size(); ++k)
    text += edit_text(c.terrain.edits[k], scene.edits[k].report);
  return text + fmt::format(
                    "\n[release]\nvolume = {:.9g}\narea = {:.1f}\nmean_depth = {:.4f}\n"
                    "greatest_depth = {:.4f}\n",
                    scene.release_volume, area, area > 0 ? scene.release_volume / area : 0,
                    scene.release_depth);
}

}  // namespace sabo
