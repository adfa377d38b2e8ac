#include "run/pictures.hpp"

#include <functional>

#include <fmt/format.h>

#include "analysis/resolution.hpp"
#include "io/gis/write_raster.hpp"
#include "io/output/file.hpp"
#include "io/output/map_picture.hpp"
#include "io/output/svg_chart.hpp"
#include "run/overlay.hpp"

namespace sabo {
namespace {

/// Rasters and lines live in the solver frame; files are in CRS coordinates.
Raster in_crs(Raster raster, const Frame& frame) {
  raster.grid.west += frame.origin_x;
  raster.grid.north += frame.origin_y;
  return raster;
}

Raster in_kilopascal(Raster raster) {
  for (double& value : raster.values) value /= 1000;
  return raster;
}

ChartSeries series_of(const std::vector<SeriesRow>& rows, std::string name,
                      const std::function<double(const SeriesRow&)>& value) {
  ChartSeries series{std::move(name)};
  for (const SeriesRow& row : rows) {
    series.x.push_back(row.time);
    series.y.push_back(value(row));
  }
  return series;
}

/// Writes pictures one after the other and keeps their captions.
class Album {
 public:
  explicit Album(const RunFolder& folder) : folder_(folder) {}

  void add(const std::string& name, const std::string& svg, const std::string& caption,
           bool is_wide) {
    write_file_atomically(folder_.pictures() / name, svg);
    pictures_.push_back({{"pictures/" + name}, caption, is_wide});
  }
  std::vector<PagePicture> take() { return std::move(pictures_); }

 private:
  const RunFolder& folder_;
  std::vector<PagePicture> pictures_;
};

/// Classes of depth in particles: orange where they are too few, violet where they are enough, in
/// the order of ColorBrewer's PuOr, which any colour vision tells apart.
std::vector<ColourStep> resolution_steps() {
  constexpr double enough = ResolutionGuard::enough_layers;
  constexpr double good = ResolutionGuard::good_layers;
  return {{enough / 2, {179, 88, 6}, fmt::format("under {:g}", enough / 2)},
          {enough, {241, 163, 64}, fmt::format("{:g} to {:g}", enough / 2, enough)},
          {good, {254, 224, 182}, fmt::format("{:g} to {:g}", enough, good)},
          {2 * good, {153, 142, 195}, fmt::format("{:g} to {:g}", good, 2 * good)},
          {0, {84, 39, 136}, fmt::format("{:g} or more", 2 * good)}};
}

void draw_resolution(const RunMaps& maps, const Case& c, const Scene& scene, Album& album) {
  MapPicture map{
      fmt::format("Resolution: under {0:g} particles too coarse, {0:g} to {1:g} barely enough",
                  ResolutionGuard::enough_layers, ResolutionGuard::good_layers),
      c.note, "particles in the greatest depth"};
  map.view = view_around(maps.peak_depth, maps.wet_depth);
  map.lines = overlay(scene);
  map.steps = resolution_steps();
  album.add("resolution.svg", map_svg(map, scene.surface->elevation(), maps.layers),
            fmt::format("Greatest depth over the particle spacing of {:g} m (maps/res.tif)",
                        c.numerics.spacing),
            true);
}

void draw_maps(const RunMaps& maps, const Case& c, const Scene& scene, Album& album) {
  const Raster& ground = scene.surface->elevation();
  const MapView view = view_around(maps.peak_depth, maps.wet_depth);
  const auto draw = [&](const char* file, const char* title, const char* quantity,
                        const Raster& values, double threshold, const char* caption) {
    MapPicture map{title, c.note, quantity, threshold};
    map.view = view;
    map.lines = overlay(scene);
    album.add(file, map_svg(map, ground, values), caption, true);
  };
  draw("deposit.svg", "Depth at the end of the run", "depth [m]", maps.deposit, maps.wet_depth,
       "Depth at the end of the run (maps/dep.tif)");
  draw("peak_depth.svg", "Greatest depth", "depth [m]", maps.peak_depth, maps.wet_depth,
       "Greatest depth of the flow (maps/pfd.tif)");
  draw("peak_speed.svg", "Greatest speed", "speed [m/s]", maps.peak_speed, 0.01,
       "Greatest speed of the flow (maps/pfv.tif)");
  draw("peak_pressure.svg", "Greatest pressure", "pressure [kPa]",
       in_kilopascal(maps.peak_pressure), 0.01,
       "Greatest pressure in the column of the flow (maps/ppr.tif)");
  draw("arrival.svg", "Arrival", "time [s]", maps.arrival, 0,
       "Time at which the flow arrived (maps/tarr.tif)");
}

void draw_series(const std::vector<SeriesRow>& rows, const Scene& scene, Album& album) {
  const auto chart = [&](const char* file, const char* title, const char* unit,
                         std::vector<ChartSeries> series, const char* caption) {
    album.add(file, chart_svg({title, "time [s]", unit, std::move(series)}), caption, false);
  };
  chart("front_velocity.svg", "Velocity of the front", "velocity [m/s]",
        {series_of(rows, "front", [](const SeriesRow& row) { return row.front.velocity; })},
        "Velocity of the front along the path (series/front.csv)");
  chart("front_displacement.svg", "Displacement of the front", "displacement [m]",
        {series_of(rows, "front", [](const SeriesRow& row) { return row.front.displacement; })},
        "Displacement of the front along the path (series/front.csv)");

  std::vector<ChartSeries> discharge;
  for (std::size_t k = 0; k < scene.sections.size(); ++k)
    discharge.push_back(series_of(rows, scene.sections[k].name,
                                  [k](const SeriesRow& row) { return row.discharge[k]; }));
  if (!discharge.empty())
    chart("discharge.svg", "Discharge through the sections", "discharge [m3/s]", discharge,
          "Discharge through the sections, counted from particle crossings "
          "(series/discharge.csv)");

  std::vector<ChartSeries> volumes;
  for (std::size_t k = 0; k < scene.check_dams().size(); ++k) {
    const std::string& dam = scene.dams[k].name;
    volumes.push_back(series_of(rows, "trapped by " + dam,
                                [k](const SeriesRow& row) { return row.volumes[k].trapped; }));
    volumes.push_back(series_of(rows, "beyond " + dam,
                                [k](const SeriesRow& row) { return row.volumes[k].beyond; }));
  }
  volumes.push_back(
      series_of(rows, "left the map", [](const SeriesRow& row) { return row.volumes[0].outflow; }));
  chart("volumes.svg", "Where the volume is", "volume [m3]", volumes,
        "Volume ledger (series/volumes.csv)");
}

}  // namespace

void write_maps(const RunMaps& maps, const Case& c, const Scene& scene, const RunFolder& folder) {
  const auto write = [&](const char* file, const Raster& raster, const std::string& what,
                         const char* unit) {
    RasterInfo info{scene.frame.crs, what, unit};
    if (!c.note.empty()) info.metadata["note"] = c.note;
    write_raster(folder.maps() / file, in_crs(raster, scene.frame), info);
  };
  write("dep.tif", maps.deposit, "vertical depth at the end of the run", "m");
  write("pfd.tif", maps.peak_depth, "greatest vertical depth", "m");
  write("pfv.tif", maps.peak_speed, "greatest mass-weighted mean speed of the column", "m/s");
  write("ppr.tif", in_kilopascal(maps.peak_pressure),
        fmt::format("greatest pressure of a particle in the column, where the flow is deeper than "
                    "{:g} m",
                    maps.wet_depth),
        "kPa");
  write("ground.tif", scene.surface->elevation(), "elevation of the ground as the run used it",
        "m");
  write(
      "res.tif", maps.layers,
      fmt::format("greatest vertical depth over the particle spacing of {:g} m, where the flow is "
                  "deeper than {:g} m",
                  c.numerics.spacing, maps.wet_depth),
      "particles");
  write("tarr.tif", maps.arrival,
        fmt::format("first time with a depth above {:g} m", maps.wet_depth), "s");
}

std::vector<PagePicture> draw_pictures(const RunMaps& maps, const std::vector<SeriesRow>& rows,
                                       const Case& c, const Scene& scene, const RunFolder& folder) {
  Album album(folder);
  draw_maps(maps, c, scene, album);
  draw_resolution(maps, c, scene, album);
  draw_series(rows, scene, album);
  return album.take();
}

}  // namespace sabo
