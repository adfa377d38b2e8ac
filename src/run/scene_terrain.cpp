#include "run/scene_terrain.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/gis/read_dem.hpp"
#include "io/gis/read_raster.hpp"
#include "math/angle.hpp"
#include "run/scene_lines.hpp"
#include "terrain/dem_difference.hpp"
#include "terrain/tilted_plane.hpp"

namespace sabo {
namespace {

constexpr double usual_cells = 4e6;  // of a plane, at most
constexpr double most_cells = 4e8;   // of a plane whose cells are given

Raster plane_ground(const PlaneCase& c, double spacing, Scene& scene) {
  const auto& [west, south, east, north] = c.extent;
  const TiltedPlane plane{
      west, south, east, north, c.elevation, std::tan(c.slope * degree), c.direction * degree};
  const double area = (east - west) * (north - south);
  const double cell = c.cell_size.value_or(std::max(2 * spacing, std::sqrt(area / usual_cells)));
  if (area / (cell * cell) > most_cells) {
    throw CaseError("terrain.plane.cell_size", "makes far too many cells",
                    fmt::format("give at least {:.2g} m", std::sqrt(area / most_cells)));
  }
  scene.frame = {std::floor(west), std::floor(south), ""};
  scene.dem_notes = {
      c.slope > 0 ? fmt::format("a plane of {:g} deg, falling to {:g} deg", c.slope, c.direction)
                  : "a level plane"};
  Raster ground = raster_of(plane, cell);
  to_frame(scene.frame, ground.grid);
  return ground;
}

Raster read_ground(const TerrainCase& c, Scene& scene) {
  Dem dem = read_dem({.file = c.dem,
                      .assume_metres = c.assume_metres,
                      .crop = c.crop,
                      .crs = c.crs,
                      .cell_size = c.cell_size.value_or(0)});
  scene.frame = {std::floor(dem.raster.grid.west), std::floor(dem.raster.grid.south()),
                 dem.crs_wkt};
  scene.dem_notes = std::move(dem.notes);
  to_frame(scene.frame, dem.raster.grid);
  scene.holes = fill_holes(dem.raster, static_cast<int>(c.fill_holes));
  return std::move(dem.raster);
}

TerrainEdit edit_of(const TerrainEditCase& c, const std::string& key, const Frame& frame) {
  TerrainEdit edit{c.name, read_area(c.polygon, key + ".polygon", frame), {}};
  switch (c.kind) {
    case TerrainEditKind::set:
      edit.change = SetElevation{c.elevation.value_or(0)};
      break;
    case TerrainEditKind::lower:
      edit.change = ShiftElevation{-c.by.value_or(0)};
      break;
    case TerrainEditKind::raise:
      edit.change = ShiftElevation{c.by.value_or(0)};
      break;
    case TerrainEditKind::smooth:
      edit.change = SmoothElevation{c.radius.value_or(0)};
      break;
  }
  return edit;
}

void make_edits(const TerrainCase& c, Raster& ground, Scene& scene, Faults& faults) {
  for (std::size_t k = 0; k < c.edits.size(); ++k) {
    const std::string key = fmt::format("terrain.edit[{}]", k + 1);
    collected(faults, [&] {
      TerrainEdit edit = edit_of(c.edits[k], key, scene.frame);
      const EditReport report = apply(edit, ground);
      if (report.cells == 0) {
        throw CaseError(key + ".polygon", "holds no centre of a cell with data",
                        "check its coordinates, or give a larger polygon");
      }
      scene.edits.push_back({report, std::move(edit.polygons)});
    });
  }
}

void dig_release(const Case& c, Raster& ground, Scene& scene) {
  const ReleaseCase& release = c.release;
  const auto read = [&](const std::filesystem::path& file, const char* key) {
    Raster raster = read_elevation(file, {key, scene.frame.crs, c.terrain.assume_metres});
    to_frame(scene.frame, raster.grid);
    return raster;
  };
  const DemPair pair{read(release.dem_before, "release.dem_before"),
                     read(release.dem_after, "release.dem_after")};
  std::vector<Polygon> within;
  if (release.polygon.given()) within = read_area(release.polygon, "release.polygon", scene.frame);
  LostGround lost{lost_thickness(pair, ground, within, release.least_thickness)};
  bool is_empty = true;
  for (const double thickness : lost.thickness.values) is_empty &= std::isnan(thickness);
  if (is_empty) {
    throw CaseError("release.dem_before", "is nowhere above dem_after within the DEM",
                    "check that the two are not swapped, and least_thickness and polygon");
  }
  lost.dug = lower_to_after(pair, lost.thickness, ground);
  scene.lost = std::move(lost);
}

}  // namespace

void read_terrain(const Case& c, Scene& scene, Faults& faults) {
  collected(faults, [&] {
    Raster ground = c.terrain.plane ? plane_ground(*c.terrain.plane, c.numerics.spacing, scene)
                                    : read_ground(c.terrain, scene);
    make_edits(c.terrain, ground, scene, faults);
    if (!c.release.dem_before.empty()) collected(faults, [&] { dig_release(c, ground, scene); });
    scene.surface = std::make_unique<Surface>(std::move(ground));
  });
}

}  // namespace sabo
