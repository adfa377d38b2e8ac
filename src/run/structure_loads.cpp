#include "run/structure_loads.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "run/series_header.hpp"

namespace sabo {
namespace {

std::vector<std::string> structure_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const CheckDam& dam : scene.dams) names.push_back(dam.name);
  for (const Body& body : scene.bodies) names.push_back(body.name());
  return names;
}

std::vector<std::string> loads_header(const Scene& scene) {
  std::vector<std::string> header{"time [s]"};
  for (const std::string& name : structure_names(scene))
    add_columns(header, name,
                {"force x [N]", "force y [N]", "force z [N]", "moment x [N m]", "moment y [N m]",
                 "moment z [N m]", "approach depth [m]", "approach speed [m/s]",
                 "approach surface [m]", "touched width [m]", "hydrostatic [N]", "dynamic [N]"});
  return header;
}

// The flow before a structure is looked for in a strip as wide as two cells or four spacings,
// behind the first cell, which the structure may share.
struct Strip {
  double from, to;  ///< distance from the structure, m
};

Strip strip_of(const Raster& elevation, double spacing) {
  const double cell = std::max(elevation.grid.dx, elevation.grid.dy);
  const double from = std::max(0.5 * cell, spacing);
  return {from, from + std::max(2 * cell, 4 * spacing)};
}

/// On the side of the release.
Approach approach_of(const CheckDam& dam, const Scene& scene, double spacing) {
  const Raster& elevation = scene.surface->elevation();
  const Strip strip = strip_of(elevation, spacing);
  const double side = scene.side_of_release(dam);
  const double span = length(dam.axis);
  return {elevation, [&, side](double x, double y) {
            const LinePlace place = project(dam.axis, x, y);
            const double distance = side * place.offset - dam.thickness / 2;
            return place.station >= 0 && place.station <= span && distance >= strip.from &&
                   distance <= strip.to;
          }};
}

/// Around the rectangle that holds the body.
Approach approach_of(const Body& body, const Scene& scene, double spacing) {
  const Raster& elevation = scene.surface->elevation();
  const Strip strip = strip_of(elevation, spacing);
  const Bounds bounds = bounds_of(body.mesh());
  return {elevation, [&](double x, double y) {
            const double dx = std::max({bounds.low.x - x, 0.0, x - bounds.high.x});
            const double dy = std::max({bounds.low.y - y, 0.0, y - bounds.high.y});
            const double distance = std::hypot(dx, dy);
            return distance >= strip.from && distance <= strip.to;
          }};
}

double horizontal(const Vec3d& v) { return std::hypot(v.x, v.y); }

}  // namespace

StructureLoads::StructureLoads(const LoadCase& settings, const Scene& scene, const FlowModel& model,
                               const RunFolder& folder)
    : settings_(settings),
      density_(model.state.rho0),
      gravity_(norm(model.gravity)),
      loads_csv_(folder.series_file("loads.csv"), loads_header(scene)),
      profiles_csv_(folder.series_file("pressure_profiles.csv"),
                    {"structure", "time [s]", "bottom [m]", "top [m]", "force x [N]", "force y [N]",
                     "width [m]", "pressure [Pa]"}) {
  for (const std::string& name : structure_names(scene)) summaries_.emplace_back().name = name;
  for (const CheckDam& dam : scene.dams)
    approaches_.push_back(approach_of(dam, scene, model.spacing));
  for (const Body& body : scene.bodies)
    approaches_.push_back(approach_of(body, scene, model.spacing));
}

std::vector<LoadRow> StructureLoads::write_row(double time, const std::vector<MeanLoad>& means,
                                               const Columns& columns) {
  std::vector<LoadRow> list;
  std::vector<double> row{time};
  for (std::size_t k = 0; k < means.size(); ++k)
    list.push_back(write_structure(k, time, means[k], columns, row));
  loads_csv_.append(row);
  return list;
}

LoadRow StructureLoads::write_structure(std::size_t number, double time, const MeanLoad& mean,
                                        const Columns& columns, std::vector<double>& row) {
  LoadSummary& summary = summaries_[number];
  double width = 0;
  for (const LoadProfile::Bin& bin : mean.profile) {
    width = std::max(width, bin.width);
    profiles_csv_.append(summary.name, std::array{time, bin.bottom, bin.top, bin.force.x,
                                                  bin.force.y, bin.width, bin.pressure()});
  }
  const ApproachState approach = approaches_[number].measure(columns);
  const double hydrostatic = hydrostatic_load(density_, gravity_, approach.depth, width);
  const double dynamic = dynamic_load(settings_.alpha, density_, approach.depth_speed2, width);
  row.insert(row.end(),
             {mean.force.x, mean.force.y, mean.force.z, mean.moment.x, mean.moment.y, mean.moment.z,
              approach.depth, approach.speed, approach.surface, width, hydrostatic, dynamic});

  summary.peak = mean.peak;
  summary.peak_time = mean.peak_time;
  summary.impulse = mean.impulse;
  summary.hydrostatic = std::max(summary.hydrostatic, hydrostatic);
  summary.dynamic = std::max(summary.dynamic, dynamic);
  if (horizontal(mean.force) > horizontal(summary.row_force)) {
    summary.row_time = time;
    summary.row_force = mean.force;
    summary.row_moment = mean.moment;
    summary.profile = mean.profile;
  }
  return {horizontal(mean.force), hydrostatic, dynamic};
}

}  // namespace sabo
