#include "run/pictures.hpp"

#include <functional>

#include <fmt/format.h>

#include "analysis/resolution.hpp"
#include "base/capitalised.hpp"
#include "io/output/file.hpp"
#include "io/output/map_picture.hpp"
#include "io/output/svg_chart.hpp"
#include "run/overlay.hpp"

namespace sabo {
namespace {

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
  for (const MapKind& kind : map_kinds()) {
    if (!kind.picture) continue;
    MapPicture map{kind.title, c.note, fmt::format("{} [{}]", kind.quantity, kind.unit),
                   kind.threshold(maps.wet_depth)};
    map.view = view;
    map.lines = overlay(scene);
    album.add(fmt::format("{}.svg", kind.picture), map_svg(map, ground, kind.values(maps, ground)),
              fmt::format("{} (maps/{}.tif)", capitalised(kind.description), kind.name), true);
  }
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
