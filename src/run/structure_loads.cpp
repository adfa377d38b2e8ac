#include "run/structure_loads.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

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
    for (const char* column :
         {"force x [N]", "force y [N]", "force z [N]", "moment x [N m]", "moment y [N m]",
          "moment z [N m]", "approach depth [m]", "approach speed [m/s]", "approach surface [m]",
          "touched width [m]", "hydrostatic [N]", "dynamic [N]"})
      header.push_back(name + " " + column);
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

Vec3d base_of(const CheckDam& dam, const Scene& scene) {
  const Vec3d middle = point_at(dam.axis, length(dam.axis) / 2);
  return {middle.x, middle.y, scene.surface->height(middle.x, middle.y)};
}

Vec3d base_of(const Body& body) {
  const Bounds bounds = bounds_of(body.mesh());
  return {0.5 * (bounds.low.x + bounds.high.x), 0.5 * (bounds.low.y + bounds.high.y), bounds.low.z};
}

double horizontal(const Vec3d& v) { return std::hypot(v.x, v.y); }

}  // namespace

struct StructureLoads::Structure {
  Vec3d base;  ///< about which moments are
  Approach approach;
  LoadPeak peak;
  LoadProfile profile;
  BodyLoad at_last_row;  ///< impulse until then
  LoadSummary summary;

  template <class Archive>
  void archive(Archive& a) {
    a(peak, profile, at_last_row, summary);
  }
};

StructureLoads::~StructureLoads() = default;

StructureLoads::StructureLoads(const LoadCase& settings, const Scene& scene, const FlowModel& model,
                               const RunFolder& folder)
    : settings_(settings),
      density_(model.state.rho0),
      gravity_(norm(model.gravity)),
      spacing_(model.spacing),
      loads_csv_(folder.series_file("loads.csv"), loads_header(scene)),
      profiles_csv_(folder.series_file("pressure_profiles.csv"),
                    {"structure", "time [s]", "bottom [m]", "top [m]", "force x [N]", "force y [N]",
                     "width [m]", "pressure [Pa]"}) {
  const auto add = [&](const std::string& name, const Vec3d& base, Approach approach) {
    Structure structure{base,
                        std::move(approach),
                        LoadPeak(settings.filter),
                        LoadProfile(base.z, spacing_, model.kernel_radius()),
                        {},
                        {}};
    structure.summary.name = name;
    structures_.push_back(std::move(structure));
  };
  for (const CheckDam& dam : scene.dams)
    add(dam.name, base_of(dam, scene), approach_of(dam, scene, spacing_));
  for (const Body& body : scene.bodies)
    add(body.name(), base_of(body), approach_of(body, scene, spacing_));
}

void StructureLoads::after_step(const Stepper& stepper, const StepReport& report,
                                Backend& backend) {
  if (is_empty()) return;
  for (const BodyForce& at : backend.body_forces()) {
    if (at.force == Vec3d{}) continue;
    structures_[at.body - 1].profile.add(at.position, report.dt * at.force);
  }
  const std::vector<BodyLoad>& impulses = stepper.body_impulses();
  for (std::size_t k = 0; k < impulses.size(); ++k)
    structures_[k].peak.add(stepper.time(), impulses[k].force);
}

std::vector<LoadRow> StructureLoads::write_row(double time, const Stepper& stepper,
                                               Backend& backend, const Columns& columns) {
  std::vector<LoadRow> list;
  for (const BodyForce& at : backend.body_forces())
    if (!at.is_foundation) structures_[at.body - 1].profile.see(at.position, at.force != Vec3d{});
  const std::vector<BodyLoad>& impulses = stepper.body_impulses();
  std::vector<double> row{time};
  for (std::size_t k = 0; k < structures_.size(); ++k)
    list.push_back(write_structure(structures_[k], time,
                                   k < impulses.size() ? impulses[k] : BodyLoad{}, columns, row));
  loads_csv_.append(row);
  last_row_ = time;
  return list;
}

LoadRow StructureLoads::write_structure(Structure& structure, double time, const BodyLoad& total,
                                        const Columns& columns, std::vector<double>& row) {
  const double interval = time - last_row_;
  BodyLoad mean = total;
  mean += -1.0 * structure.at_last_row;
  mean = (interval > 0 ? 1 / interval : 0.0) * mean;
  structure.at_last_row = total;
  const Vec3d moment = mean.moment_about(structure.base);

  std::vector<LoadProfile::Bin> profile = structure.profile.take(interval);
  double width = 0;
  for (const LoadProfile::Bin& bin : profile) {
    width = std::max(width, bin.width);
    profiles_csv_.append(
        structure.summary.name,
        std::array{time, bin.bottom, bin.top, bin.force.x, bin.force.y, bin.width, bin.pressure()});
  }
  const ApproachState approach = structure.approach.measure(columns);
  const double hydrostatic = hydrostatic_load(density_, gravity_, approach.depth, width);
  const double dynamic = dynamic_load(settings_.alpha, density_, approach.depth_speed2, width);
  row.insert(row.end(),
             {mean.force.x, mean.force.y, mean.force.z, moment.x, moment.y, moment.z,
              approach.depth, approach.speed, approach.surface, width, hydrostatic, dynamic});

  LoadSummary& summary = structure.summary;
  summary.peak = structure.peak.force();
  summary.peak_time = structure.peak.time();
  summary.impulse = total.force;
  summary.hydrostatic = std::max(summary.hydrostatic, hydrostatic);
  summary.dynamic = std::max(summary.dynamic, dynamic);
  if (horizontal(mean.force) > horizontal(summary.row_force)) {
    summary.row_time = time;
    summary.row_force = mean.force;
    summary.row_moment = moment;
    summary.profile = std::move(profile);
  }
  return {horizontal(mean.force), hydrostatic, dynamic};
}

template <class Archive>
void StructureLoads::archive(Archive& a) {
  a(last_row_);
  a.fixed(structures_);
  a(loads_csv_, profiles_csv_);
}

template void StructureLoads::archive(ArchiveWriter&);
template void StructureLoads::archive(ArchiveReader&);

std::vector<LoadSummary> StructureLoads::summaries() const {
  std::vector<LoadSummary> list;
  for (const Structure& structure : structures_) list.push_back(structure.summary);
  return list;
}

}  // namespace sabo
