#include "run/new_case.hpp"

#include <array>
#include <cmath>
#include <map>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.hpp"
#include "base/faults.hpp"
#include "io/case_file/templates.hpp"
#include "io/gis/crs.hpp"
#include "io/gis/target_crs.hpp"
#include "io/gis/write_raster.hpp"
#include "io/gis/write_vectors.hpp"
#include "io/output/file.hpp"
#include "terrain/valley.hpp"

namespace sabo {
namespace {

namespace fs = std::filesystem;

// The generated valley starts at a round number of the zone that Amami Oshima is in (UTM 52 N). It
// is not where the real channel is.
constexpr int valley_epsg = 32652;
constexpr double valley_easting = 350'000;     // m
constexpr double valley_northing = 3'130'000;  // m
constexpr double cell_size = 1;                // m
constexpr const char* origin_note =
    "Generated from the published numbers of the 2010 debris flow at Yohutagawa; not the real "
    "terrain and not at its real place";

Raster on_the_map(Raster raster) {
  raster.grid.west += valley_easting;
  raster.grid.north += valley_northing;
  return raster;
}

Polyline on_the_map(Polyline line) {
  for (Vec3d& vertex : line.vertices) vertex += Vec3d{valley_easting, valley_northing, 0};
  return line;
}

/// Thickness of the source on cells that coincide with those of the DEM.
Raster release_thickness(const Grid& dem) {
  const ReleaseShape shape = valley_release();
  const int first_column = dem.column_of(shape.west);
  const int first_row = dem.row_of(shape.north);
  Grid grid = dem;
  grid.columns = dem.column_of(shape.east) - first_column + 1;
  grid.rows = dem.row_of(shape.south) - first_row + 1;
  grid.west = dem.west + first_column * dem.dx;
  grid.north = dem.north - first_row * dem.dy;
  Raster thickness(grid, Raster::no_data);
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const double value = shape.thickness(grid.x_of(column), grid.y_of(row));
      if (value > 0) thickness.at(column, row) = value;
    }
  }
  return thickness;
}

std::array<double, 2> on_the_map(double x, double y) {
  return {std::round((valley_easting + x) * 100) / 100,
          std::round((valley_northing + y) * 100) / 100};
}

/// The valley from x to x within a distance of its axis.
YohutagawaNumbers::Zone zone_of(const char* name, double from, double to, double half_width) {
  const double start = valley_axis(from);
  const double end = valley_axis(to);
  return {name,
          {on_the_map(from, start - half_width), on_the_map(to, end - half_width),
           on_the_map(to, end + half_width), on_the_map(from, start + half_width)}};
}

/// Across the valley at x, from the right bank to the left one: then discharge down the valley is
/// positive.
YohutagawaNumbers::Section section_at(double x) {
  constexpr double half_width = 40;  // m; its ends stand more than 15 m above the bed
  const Vec3d along = normalised(Vec3d{1, valley_axis(x + 0.5) - valley_axis(x - 0.5), 0});
  const auto point = [&](double to_the_left) {
    return on_the_map(x - to_the_left * along.y, valley_axis(x) + to_the_left * along.x);
  };
  return {point(-half_width), point(half_width)};
}

void write_yohutagawa(const fs::path& folder) {
  const std::string crs = wkt_of(crs_of_code(valley_epsg));
  const std::map<std::string, std::string> note{{"NOTE", origin_note}};
  const Raster dem = valley_dem(cell_size);
  write_raster(folder / "dem.tif", on_the_map(dem), {crs, "elevation", "m", note});
  write_raster(folder / "release.tif", on_the_map(release_thickness(dem.grid)),
               {crs, "release thickness, vertical", "m", note});

  const CheckDam dam = valley_dam();
  write_lines(folder / "dam.gpkg", {{dam.name, on_the_map(dam.axis)}}, crs);
  write_lines(folder / "path.gpkg", {{"path", on_the_map(valley_path())}}, crs);

  constexpr double distance = 20;  // m along the valley, of p1 and p2 from the dam
  const double dam_x = point_at(dam.axis, dam.notch->centre).x;
  YohutagawaNumbers numbers;
  numbers.dam_thickness = dam.thickness;
  numbers.notch_centre = std::round(dam.notch->centre * 100) / 100;
  numbers.notch_width = dam.notch->width;
  numbers.notch_depth = dam.notch->depth;
  numbers.above_dam = section_at(dam_x - distance);
  numbers.below_dam = section_at(dam_x + distance);
  numbers.zones = {zone_of("behind the dam", dam_x - 60, dam_x - 2, 25),
                   zone_of("below the dam", dam_x + 2, 700, 30), zone_of("upper fan", 700, 800, 50),
                   zone_of("lower fan", 800, 1000, 70)};
  write_file_atomically(folder / "case.toml", yohutagawa_text(numbers));
}

void write_valley_from_dem(const fs::path& folder) {
  write_file_atomically(folder / "case.toml", valley_from_dem_text());
}

void write_dam_break(const fs::path& folder) {
  write_file_atomically(folder / "case.toml", dam_break_text());
}

void write_flume(const fs::path& folder) {
  write_file_atomically(folder / "walls.obj", flume_walls_text());
  write_file_atomically(folder / "case.toml", flume_text());
}

struct Writer {
  std::string_view name;
  void (*write)(const fs::path& folder);
};
constexpr std::array<Writer, templates.size()> writers{{{"yohutagawa", write_yohutagawa},
                                                        {"valley-from-dem", write_valley_from_dem},
                                                        {"dam-break", write_dam_break},
                                                        {"flume", write_flume}}};

const Writer& writer_of(const std::string& name) {
  std::vector<std::string> names;
  for (const Writer& writer : writers) {
    if (writer.name == name) return writer;
    names.emplace_back(writer.name);
  }
  const std::string near = nearest_word(name, names);
  throw CaseError("", fmt::format("there is no template \"{}\"", name),
                  near.empty() ? fmt::format("use one of: {}", fmt::join(names, ", "))
                               : fmt::format("did you mean \"{}\"?", near));
}

void make_empty_folder(const fs::path& folder) {
  std::error_code error;
  if (fs::exists(folder, error)) {
    if (!fs::is_directory(folder, error)) {
      throw CaseError(folder.string(), "is a file",
                      "give a folder that is empty or does not exist");
    }
    if (!fs::is_empty(folder, error)) {
      throw CaseError(folder.string(), "has files in it",
                      "give a folder that is empty or does not exist");
    }
  }
  fs::create_directories(folder, error);
  if (error) {
    throw CaseError(folder.string(), "cannot be made: " + error.message(), "give another folder");
  }
}

}  // namespace

void new_case(const std::string& template_name, const fs::path& folder) {
  const Writer& writer = writer_of(template_name);
  make_empty_folder(folder);
  writer.write(folder);
}

}  // namespace sabo
