#include "run/view.hpp"

#include <algorithm>
#include <cmath>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/version.hpp"
#include "io/output/file.hpp"
#include "io/output/read_file.hpp"
#include "io/output/view_frame.hpp"
#include "io/output/view_page.hpp"
#include "run/overlay.hpp"
#include "run/surface_frames.hpp"
#include "run/view_solids.hpp"

namespace sabo {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_shown = 200'000;              // of a frame
constexpr std::size_t most_shown_cells = 160'000;        // of the ground
constexpr std::size_t whole_map = 2 * most_shown_cells;  // a map up to this size is shown whole
constexpr double inliers = 0.995;  // share of a frame's particles that the colours reach

/// The value that all but a few exceptions do not exceed; at least `least`.
double usual_top(std::vector<float> values, double least) {
  if (values.empty()) return least;
  const auto place = values.begin() +
                     static_cast<std::ptrdiff_t>(inliers * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return std::max<double>(least, *place);
}

void widen(MapView& view, const Vec3d& point) {
  view.west = std::min(view.west, point.x);
  view.east = std::max(view.east, point.x);
  view.south = std::min(view.south, point.y);
  view.north = std::max(view.north, point.y);
}

/// Every `stride`-th cell of the part of a raster that a view touches, from its north-western one
/// on; centres stay where they are.
Raster thinned(const Raster& raster, const MapView& view, int stride) {
  const Grid& from = raster.grid;
  const auto cell = [](int number, int count) { return std::clamp(number, 0, count - 1); };
  const int west = cell(from.column_of(view.west), from.columns);
  const int east = cell(from.column_of(view.east), from.columns);
  const int north = cell(from.row_of(view.north), from.rows);
  const int south = cell(from.row_of(view.south), from.rows);
  Grid grid;
  grid.columns = std::max(2, (east - west) / stride + 1);
  grid.rows = std::max(2, (south - north) / stride + 1);
  grid.dx = from.dx * stride;
  grid.dy = from.dy * stride;
  grid.west = from.x_of(west) - grid.dx / 2;
  grid.north = from.y_of(north) + grid.dy / 2;
  Raster result(grid, Raster::no_data);
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const int c = west + column * stride, r = north + row * stride;
      if (from.has_cell(c, r)) result.at(column, row) = raster.at(c, r);
    }
  }
  return result;
}

}  // namespace

ViewWriter::ViewWriter(fs::path folder, const Case& c, const Scene& scene)
    : case_(c), scene_(scene), folder_(std::move(folder)) {
  std::error_code error;
  fs::remove_all(folder_, error);
  make_folder(folder_);
  one_of_ = (scene.particles_until(c.run.duration) + most_shown - 1) / most_shown;
  one_of_ = std::max<std::size_t>(one_of_, 1);
}

void ViewWriter::add(const RunFrame& frame) {
  const Particles& particles = frame.particles;
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < particles.size(); ++i)
    if (particles.id[i] % one_of_ == 0) order.push_back(i);
  std::ranges::sort(order, {}, [&](std::size_t i) { return particles.id[i]; });

  const Grid& grid = scene_.surface->elevation().grid;
  ViewFrame shown;
  for (const std::size_t i : order) {
    const Vec3d& x = particles.position[i];
    const int column = std::clamp(grid.column_of(x.x), 0, grid.columns - 1);
    const int row = std::clamp(grid.row_of(x.y), 0, grid.rows - 1);
    shown.id.push_back(static_cast<std::uint32_t>(particles.id[i] / one_of_));
    const std::array<double, 6> values{x.x,
                                       x.y,
                                       x.z - scene_.surface->height(x.x, x.y),
                                       frame.columns.depth(grid.index(column, row)),
                                       norm(particles.velocity[i]),
                                       particles.pressure[i]};
    for (std::size_t k = 0; k < values.size(); ++k)
      shown.values[k].push_back(static_cast<float>(values[k]));
    if (!has_flow_) reach_ = {x.x, x.y, x.x, x.y};
    has_flow_ = true;
    widen(reach_, x);
  }
  const auto raise = [&](double& top, ViewValue value) {
    top = usual_top(shown.values[static_cast<std::size_t>(value)], top);
  };
  raise(view_.depth_top, ViewValue::depth);
  raise(view_.speed_top, ViewValue::speed);
  raise(view_.pressure_top, ViewValue::pressure);
  write_file_atomically(folder_ / view_frame_file(frame.number),
                        view_frame_script(frame.number, shown));
  view_.frames.push_back({frame.number, frame.time, order.size()});
}

void ViewWriter::finish() {
  view_.title = case_.title.empty() ? "Debris flow" : case_.title;
  view_.note = case_.note;
  view_.run = fs::absolute(folder_).lexically_normal().parent_path().filename().string();
  view_.program = fmt::format("sabo {}", build_version);
  view_.frame = scene_.frame;
  view_.spacing = case_.numerics.spacing;
  view_.one_of = one_of_;
  view_.solids = view_solids(case_, scene_);
  for (const MapLine& line : overlay(scene_))
    if (line.kind != MapLine::Kind::dam) view_.lines.push_back(line);

  const Raster& elevation = scene_.surface->elevation();
  const Grid& grid = elevation.grid;
  MapView window{grid.west, grid.south(), grid.east(), grid.north};
  if (grid.size() > whole_map && has_flow_) {
    window = reach_;
    for (const MapLine& line : view_.lines)
      for (const Vec3d& vertex : line.line.vertices) widen(window, vertex);
    const double margin =
        0.15 * std::max(window.east - window.west, window.north - window.south) + 10 * grid.dx;
    window = {window.west - margin, window.south - margin, window.east + margin,
              window.north + margin};
  }
  const double wide = std::min(grid.east(), window.east) - std::max(grid.west, window.west);
  const double high = std::min(grid.north, window.north) - std::max(grid.south(), window.south);
  const double cells = wide * high / grid.cell_area();
  view_.stride = cells <= static_cast<double>(whole_map)
                     ? 1
                     : static_cast<int>(std::ceil(std::sqrt(cells / most_shown_cells)));
  view_.ground = thinned(elevation, window, view_.stride);
  write_file_atomically(folder_ / "index.html", view_page());
  write_file_atomically(folder_ / "scene.js", view_scene_script(view_));
}

void write_from_frames(const fs::path& run_folder, const Case& c, const Scene& scene) {
  try {
    ViewWriter view(run_folder / "view", c, scene);
    SurfaceFrames surfaces(run_folder / "frames", scene);
    for_each_frame(run_folder, c, scene, [&](const RunFrame& frame) {
      surfaces.write(frame);
      view.add(frame);
    });
    surfaces.finish();
    view.finish();
  } catch (const CaseError& error) {  // the frames were written a moment ago
    throw RunError(error.what());
  }
}

fs::path view_of_run(const fs::path& run_folder) {
  const fs::path folder = run_folder / "view";
  const std::vector<PvdEntry> frames = frames_of(run_folder);
  const std::string begin = fmt::format("sabo_scene({{\"format\":{},", view_format);
  const auto scene = read_file(folder / "scene.js", std::size_t{1} << 30);
  if (scene && scene->starts_with(begin)) return folder;
  const FinishedScene finished = scene_of_run(run_folder);
  ViewWriter view(folder, finished.run_case, finished.scene);
  for_each_frame(run_folder, finished.run_case, finished.scene,
                 [&](const RunFrame& frame) { view.add(frame); });
  view.finish();
  return folder;
}

}  // namespace sabo
