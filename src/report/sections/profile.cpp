#include <algorithm>
#include <cmath>
#include <optional>

#include "report/report_parts.hpp"

#include "terrain/bilinear.hpp"

namespace sabo {
namespace {

constexpr int most_points = 800;

const MapLine* path_of(RunRecord& run) {
  const auto& lines = run.plan();
  const auto found = std::ranges::find(lines, MapLine::Kind::path, &MapLine::kind);
  return found == lines.end() ? nullptr : &*found;
}

/// Where two pieces cross, as the share of the first; nothing if they do not.
std::optional<double> crossing(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
  const double denominator = (b.x - a.x) * (d.y - c.y) - (b.y - a.y) * (d.x - c.x);
  if (denominator == 0) return std::nullopt;
  const double s = ((c.x - a.x) * (d.y - c.y) - (c.y - a.y) * (d.x - c.x)) / denominator;
  const double t = ((c.x - a.x) * (b.y - a.y) - (c.y - a.y) * (b.x - a.x)) / denominator;
  return s >= 0 && s <= 1 && t >= 0 && t <= 1 ? std::optional(s) : std::nullopt;
}

struct PathCrossing {
  double station = 0;  ///< m
  double z = 0;        ///< of the other line there, m
};

/// The first place at which a line crosses the path.
std::optional<PathCrossing> crossing_of(const Polyline& path, const Polyline& line) {
  double station = 0;
  for (std::size_t i = 0; i + 1 < path.vertices.size(); ++i) {
    const Vec3d &a = path.vertices[i], &b = path.vertices[i + 1];
    const double piece = std::hypot(b.x - a.x, b.y - a.y);
    for (std::size_t j = 0; j + 1 < line.vertices.size(); ++j) {
      const Vec3d &c = line.vertices[j], &d = line.vertices[j + 1];
      const auto share = crossing(a, b, c, d);
      const auto share_of_line = crossing(c, d, a, b);
      if (share && share_of_line)
        return PathCrossing{station + *share * piece, c.z + *share_of_line * (d.z - c.z)};
    }
    station += piece;
  }
  return std::nullopt;
}

struct Profile {
  std::vector<double> station, ground, peak, deposit, peak_depth, deposit_depth;
};

/// Ground and depths along the path, a point for each cell, at most `most_points`.
Profile profile_along(const Polyline& path, const Raster& ground, const Raster& peak,
                      const Raster* deposit) {
  const double end = length(path);
  const double step = std::max(std::min(ground.grid.dx, ground.grid.dy), end / most_points);
  const int count = static_cast<int>(end / step);
  Profile profile;
  for (int k = 0; k <= count; ++k) {
    const Vec3d place = point_at(path, k * step);
    const double z = bilinear(ground, place.x, place.y, Raster::no_data);
    const double depth = bilinear(peak, place.x, place.y, 0);
    const double left = deposit ? bilinear(*deposit, place.x, place.y, 0) : Raster::no_data;
    profile.station.push_back(k * step);
    profile.ground.push_back(z);
    profile.peak.push_back(z + depth);
    profile.deposit.push_back(z + left);
    profile.peak_depth.push_back(depth);
    profile.deposit_depth.push_back(left);
  }
  return profile;
}

/// Structures with their crests, and sections, where they cross the path.
std::vector<ChartMark> marks_along(RunRecord& run, const Polyline& path, const Raster& ground) {
  std::vector<ChartMark> marks;
  for (const MapLine& line : run.plan()) {
    const bool is_structure = line.kind == MapLine::Kind::dam;
    if (!is_structure && line.kind != MapLine::Kind::section) continue;
    const auto at = crossing_of(path, line.line);
    if (!at) continue;
    ChartMark mark{at->station, line.label};
    const Vec3d place = point_at(path, at->station);
    const double z = bilinear(ground, place.x, place.y, Raster::no_data);
    if (is_structure && line.line.has_z && at->z > z) {
      mark.low = z;
      mark.high = at->z;
    }
    marks.push_back(mark);
  }
  std::ranges::sort(marks, {}, &ChartMark::x);
  return marks;
}

}  // namespace

void add_profile(Report& report) {
  const auto& [run, other, say, page, sharpness] = report;
  page.section(say("profile.title"));
  const MapLine* path = path_of(run);
  const MapRecord* ground = run.map("ground");
  const MapRecord* peak = run.map("pfd");
  const MapRecord* deposit = run.map("dep");
  if (!path) return tell_missing(report, "maps/plan.geojson");
  if (!ground || !peak) return tell_missing(report, "maps/ground.tif, maps/pfd.tif");
  const Profile profile =
      profile_along(path->line, ground->raster, peak->raster, deposit ? &deposit->raster : nullptr);
  const std::string source =
      data_line(report, {"maps/ground.tif", "maps/pfd.tif", "maps/dep.tif", "maps/plan.geojson"});
  page.text(say("profile.about"));
  LineChart elevation{say("profile.elevation"), say("axis.station"), say("axis.elevation")};
  elevation.has_zero = false;
  elevation.series = {{say("profile.ground"), profile.station, profile.ground},
                      {say("profile.surface"), profile.station, profile.peak},
                      {say("profile.deposit"), profile.station, profile.deposit}};
  elevation.marks = marks_along(run, path->line, ground->raster);
  LineChart depth{say("profile.depth"), say("axis.station"), say("axis.depth")};
  depth.series = {{say("profile.peak_depth"), profile.station, profile.peak_depth},
                  {say("profile.deposit_depth"), profile.station, profile.deposit_depth}};
  depth.marks = elevation.marks;
  for (ChartMark& mark : depth.marks) mark.low = mark.high = std::nullopt;
  page.chart(elevation, source);
  page.chart(depth, source);
}

}  // namespace sabo
