#include "run/pictures.hpp"

#include <functional>

#include <fmt/format.h>

#include "analysis/bed_normal.hpp"
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

Raster in_kilo(Raster raster) {
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
  draw("peak_pressure.svg", "Greatest pressure", "pressure [kPa]", in_kilo(maps.peak_pressure),
       0.01, "Greatest pressure in the column of the flow (maps/ppr.tif)");
  draw("peak_momentum.svg", "Greatest momentum flux", "density x depth x speed² [kN/m]",
       in_kilo(maps.peak_momentum), 0.01,
       "Greatest momentum flux per width: what it would push with against a wall (maps/pmf.tif)");
  draw("arrival.svg", "Arrival", "time [s]", maps.arrival, 0,
       "Time at which the flow arrived (maps/tarr.tif)");
}

/// A chart per structure: what it bore beside the design formulas.
void draw_loads(const std::vector<SeriesRow>& rows, const std::vector<LoadSummary>& loads,
                Album& album) {
  const auto kilo = [&rows](std::string name, std::size_t k, double LoadRow::*value) {
    return series_of(rows, std::move(name),
                     [k, value](const SeriesRow& row) { return row.loads[k].*value / 1000; });
  };
  for (std::size_t k = 0; k < loads.size(); ++k) {
    LineChart chart{"Horizontal force on " + loads[k].name, "time [s]", "force [kN]"};
    chart.series = {kilo("computed", k, &LoadRow::force),
                    kilo("½ ρ g h²", k, &LoadRow::hydrostatic),
                    kilo("α ρ h v²", k, &LoadRow::dynamic)};
    album.add(fmt::format("force_{}.svg", k + 1), chart_svg(chart),
              "Force beside the design formulas, which take depth h and speed v from the flow "
              "before the structure (series/loads.csv)",
              false);
    ChartSeries over_height{fmt::format("at {:.1f} s", loads[k].row_time)};
    for (const LoadProfile::Bin& bin : loads[k].profile) {
      over_height.x.push_back(bin.pressure() / 1000);
      over_height.y.push_back(0.5 * (bin.bottom + bin.top));
    }
    LineChart profile{"Pressure on " + loads[k].name, "pressure [kPa]", "elevation [m]"};
    over_height.has_markers = true;
    profile.series = {std::move(over_height)};
    if (loads[k].profile.empty()) continue;
    profile.y_low = loads[k].profile.front().bottom;
    profile.y_high = loads[k].profile.back().top;
    album.add(fmt::format("pressure_{}.svg", k + 1), chart_svg(profile),
              "Mean horizontal pressure over the height when the force was greatest "
              "(series/pressure_profiles.csv)",
              false);
  }
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

  std::vector<ChartSeries> filling;
  for (std::size_t k = 0; k < scene.check_dams().size(); ++k)
    if (!rows.empty() && rows.back().basins[k].filled > 0)
      filling.push_back(series_of(rows, scene.dams[k].name, [k](const SeriesRow& row) {
        return 100 * row.basins[k].filled;
      }));
  if (!filling.empty())
    chart("filling.svg", "Filling of the basins", "share of the capacity [%]", filling,
          "Volume below a level pool that would just not flow over, share of its capacity "
          "(series/filling.csv)");
}

}  // namespace

// In the order of ColorBrewer's PuOr, which any colour vision tells apart.
std::vector<ColourStep> resolution_steps() {
  constexpr double enough = ResolutionGuard::enough_layers;
  constexpr double good = ResolutionGuard::good_layers;
  return {{enough / 2, {179, 88, 6}, fmt::format("under {:g}", enough / 2)},
          {enough, {241, 163, 64}, fmt::format("{:g} to {:g}", enough / 2, enough)},
          {good, {254, 224, 182}, fmt::format("{:g} to {:g}", enough, good)},
          {2 * good, {153, 142, 195}, fmt::format("{:g} to {:g}", good, 2 * good)},
          {0, {84, 39, 136}, fmt::format("{:g} or more", 2 * good)}};
}

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
  write("ppr.tif", in_kilo(maps.peak_pressure),
        fmt::format("greatest pressure of a particle in the column, where the flow is deeper than "
                    "{:g} m",
                    maps.wet_depth),
        "kPa");
  write("pmf.tif", in_kilo(maps.peak_momentum),
        fmt::format("greatest momentum flux per width, density x depth x speed^2 of the column, "
                    "where the flow is deeper than {:g} m",
                    maps.wet_depth),
        "kN/m");
  const Raster& ground = scene.surface->elevation();
  write("det.tif", bed_normal_thickness(maps.deposit, ground),
        "thickness normal to the ground at the end of the run", "m");
  write("pft.tif", bed_normal_thickness(maps.peak_depth, ground),
        "greatest thickness normal to the ground", "m");
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
                                       const std::vector<LoadSummary>& loads, const Case& c,
                                       const Scene& scene, const RunFolder& folder) {
  Album album(folder);
  draw_maps(maps, c, scene, album);
  draw_resolution(maps, c, scene, album);
  draw_series(rows, scene, album);
  draw_loads(rows, loads, album);
  return album.take();
}

}  // namespace sabo
