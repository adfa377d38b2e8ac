#include "run/gauges.hpp"

#include <algorithm>

#include "analysis/probes.hpp"
#include "run/series_header.hpp"

namespace sabo {
namespace {

std::vector<std::string> gauge_columns(const Scene& scene) {
  std::vector<std::string> names{"time [s]"};
  for (const NamedGauge& gauge : scene.gauges)
    add_columns(names, gauge.name, {"depth [m]", "surface [m]", "speed [m/s]", "pressure [Pa]"});
  return names;
}

}  // namespace

Gauges::Gauges(const Scene& scene, const FlowModel& model, const RunFolder& folder)
    : scene_(scene), model_(model), csv_(folder.series_file("gauges.csv"), gauge_columns(scene)) {}

void Gauges::write_row(double time, const Particles& fluid, const Columns& columns) {
  const Raster& ground = scene_.surface->elevation();
  const auto kernel = model_.kernel<double>();
  std::vector<double> row{time};
  for (const NamedGauge& gauge : scene_.gauges) {
    const Vec3d& place = gauge.place;
    const std::size_t cell =
        ground.grid.index(ground.grid.column_of(place.x), ground.grid.row_of(place.y));
    const double depth = columns.depth(cell);
    const double speed = columns.is_wet(cell) ? columns.speed(cell) : 0;
    const double pressure = std::max(0.0, pressure_at(fluid, place, kernel, model_.gravity));
    row.insert(row.end(),
               {depth, scene_.surface->height(place.x, place.y) + depth, speed, pressure});
  }
  csv_.append(row);
}

}  // namespace sabo
