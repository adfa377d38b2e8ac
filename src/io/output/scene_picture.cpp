#include "io/output/scene_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "io/output/scene_overlay.hpp"
#include "io/output/scene_shading.hpp"
#include "io/output/scene_view.hpp"
#include "io/output/svg.hpp"
#include "io/output/svg_colour_bar.hpp"
#include "io/output/ticks.hpp"
#include "math/angle.hpp"

namespace sabo {
namespace {

constexpr double picture_width = 1100;      // px
constexpr double tallest = 720;             // px
constexpr double lowest = 160;              // px
constexpr double scene_margin = 20;         // px
constexpr double max_scene_pixels = 1.5e6;  // of the embedded picture
constexpr std::size_t mesh_size = 1'000'000;
constexpr std::size_t trial_mesh_size = 20'000;

// Up the valley, from the lower end of the path's part in the view to its upper end.
std::optional<double> azimuth_of_path(const ScenePicture& scene) {
  for (const MapLine& line : scene.lines) {
    if (line.kind != MapLine::Kind::path) continue;
    std::vector<Vec3d> within;
    for (const Vec3d& v : line.line.vertices) {
      const bool is_inside = v.x >= scene.view.west && v.x <= scene.view.east &&
                             v.y >= scene.view.south && v.y <= scene.view.north;
      if (is_inside) within.push_back(v);
    }
    if (within.size() < 2) continue;
    const Vec3d up = within.front() - within.back();
    if (std::hypot(up.x, up.y) > 0) return std::atan2(up.x, up.y) / degree;
  }
  return {};
}

// Directions as drawn on maps: from the left of the picture and a little from behind, 45 degrees
// up.
Vec3d light_for(const LookDirection& direction) {
  const double azimuth = (direction.azimuth - 150) * degree;
  return normalised(Vec3d{std::sin(azimuth), std::cos(azimuth), 1});
}

double greatest_value(const SceneMesh& mesh) {
  double result = 0;
  for (const SceneVertex& vertex : mesh.vertices) {
    if (vertex.is_wet) result = std::max<double>(result, vertex.value);
  }
  return result;
}

// About ten contour lines over the relief shown.
double contour_step(const SceneMesh& mesh) {
  double highest = mesh.base;
  for (const SceneVertex& vertex : mesh.vertices) {
    if (!std::isnan(vertex.z)) highest = std::max<double>(highest, vertex.elevation);
  }
  return highest > mesh.base ? round_down((highest - mesh.base) / 8) : 1;
}

// Rows of the camera's picture that show something.
struct Rows {
  double top = 0;
  double bottom = tallest;
};

// `more` are points besides the ground.
Rows rows_shown(const SceneMesh& mesh, const std::vector<Vec3d>& more, const Camera& camera) {
  double top = tallest, bottom = 0;
  for (const Vec3d& point : more) {
    const Projected p = camera.project(point);
    if (p.distance > 0) top = std::min(top, std::max(p.y, 0.0));
  }
  for (int row = 0; row < mesh.rows(); ++row) {
    for (int column = 0; column < mesh.columns(); ++column) {
      const Projected p = camera.project(mesh.point(column, row));
      if (!(p.distance > 0 && p.x >= 0 && p.x <= picture_width)) continue;
      top = std::min(top, p.y);
      bottom = std::max(bottom, p.y);
    }
  }
  // Room above for labels.
  Rows rows{std::floor(std::max(top - 40, 0.0)), std::ceil(std::min(bottom + 12, tallest))};
  const double missing = std::max(0.0, lowest - (rows.bottom - rows.top));
  return {rows.top - missing / 2, rows.bottom + missing / 2};
}

constexpr std::array compass_words{"N", "NE", "E", "SE", "S", "SW", "W", "NW"};

// Compass with the needle as it lies on the ground, at the right end of the legend.
std::string draw_compass(const LookDirection& direction, double x, double y) {
  constexpr double radius = 24;
  const double flat = std::max(std::sin(direction.down * degree), 0.15);
  const auto on_page = [&](double azimuth, double length) {
    const double turn = (azimuth - direction.azimuth) * degree;
    return std::array{x + length * std::sin(turn), y - length * flat * std::cos(turn)};
  };
  const auto tip = on_page(0, radius), tail = on_page(180, radius);
  const auto left = on_page(-90, 6), right = on_page(90, 6);
  std::string svg = fmt::format(
      "<ellipse cx=\"{:.1f}\" cy=\"{:.1f}\" rx=\"{:.1f}\" ry=\"{:.1f}\" fill=\"none\" "
      "stroke=\"#9aa5b1\"/>\n<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}z\" "
      "fill=\"{}\"/>\n<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}z\" fill=\"#ffffff\" "
      "stroke=\"{}\" stroke-width=\"0.8\"/>\n",
      x, y, radius, radius * flat, tip[0], tip[1], left[0], left[1], right[0], right[1], svg_ink,
      tail[0], tail[1], left[0], left[1], right[0], right[1], svg_ink);
  const auto letter = on_page(0, radius + 9);
  return svg + svg_text(letter[0], letter[1] + 4, "N",
                        {.size = 12, .colour = svg_ink, .anchor = Anchor::middle, .bold = true});
}

// Everything that a picture is made from.
struct Drawing {
  const ScenePicture& scene;
  SceneMesh mesh;
  LookDirection direction;
  CanvasView view = {};
  std::vector<SceneBody> bodies = {};  // what of them is in the view
  double height = tallest;             // px
  double contour = 10;                 // m
  double top = 48;                     // px, of the picture on the page
};

// Length across the picture at the middle of what it shows, direction of view, contour lines.
std::string draw_scale(const Drawing& d, double y) {
  double distance = 0;
  const std::vector<Vec3d> points = points_to_show(d.mesh);
  for (const Vec3d& point : points) distance += d.view.camera.project(point).distance;
  const double scale = d.view.camera.focal / (distance / static_cast<double>(points.size()));
  const double length = round_down(180 / scale);
  const double right = scene_margin + picture_width - 84;
  const double left = right - length * scale;
  std::string svg = fmt::format(
      "<path d=\"M{0:.1f} {2:.1f}v6H{1:.1f}v-6\" fill=\"none\" stroke=\"{3}\" "
      "stroke-width=\"1.6\"/>\n",
      left, right, y - 6, svg_ink);
  svg += svg_text((left + right) / 2, y - 8, fmt::format("{:g} m in mid-distance", length),
                  {.colour = svg_ink, .anchor = Anchor::middle});
  const double azimuth = std::fmod(std::fmod(d.direction.azimuth, 360) + 360, 360);
  std::string text = fmt::format("looking {} ({:.0f}°), {:.0f}° down; contours every {:g} m",
                                 compass_words[std::lround(azimuth / 45) % 8], azimuth,
                                 d.direction.down, d.contour);
  if (d.scene.exaggeration != 1) text += fmt::format("; heights × {:g}", d.scene.exaggeration);
  svg += svg_text(right, y + 20, text, {.anchor = Anchor::end});
  return svg + draw_compass(d.direction, scene_margin + picture_width - 36, y);
}

std::string draw_picture(const Drawing& d, const DepthCanvas& canvas, double top_value) {
  const Image image = shaded(canvas, {top_value > 0 ? top_value : 1, d.contour});
  return fmt::format(
      "<image x=\"{0}\" y=\"{1}\" width=\"{2}\" height=\"{3}\" preserveAspectRatio=\"none\" "
      "href=\"{4}\"/>\n<rect x=\"{0}\" y=\"{1}\" width=\"{2}\" height=\"{3}\" fill=\"none\" "
      "stroke=\"#9aa5b1\"/>\n",
      scene_margin, d.top, picture_width, d.height, data_url_of_png(png_of(image)));
}

LookDirection direction_for(const ScenePicture& scene, const SceneData& data) {
  if (scene.azimuth && scene.down) return {*scene.azimuth, *scene.down};
  return choose_direction(scene_mesh(data, scene.view, trial_mesh_size, scene.exaggeration),
                          {scene.azimuth, scene.down, azimuth_of_path(scene)});
}

Drawing drawing_of(const ScenePicture& scene, const SceneData& data) {
  Drawing d{scene, scene_mesh(data, scene.view, mesh_size, scene.exaggeration),
            direction_for(scene, data)};
  light_mesh(d.mesh, light_for(d.direction));
  std::vector<Vec3d> points = points_to_show(d.mesh);
  std::vector<Vec3d> of_bodies;
  for (const SceneBody& body : scene.bodies) {
    d.bodies.push_back(within(scene.view, body));
    for (const Vec3d& v : d.bodies.back().mesh.vertices)
      of_bodies.push_back({v.x, v.y, d.mesh.drawn(v.z)});
  }
  points.insert(points.end(), of_bodies.begin(), of_bodies.end());
  d.view.camera = camera_around(points, d.direction, picture_width, tallest, d.mesh.spacing());
  const Rows rows = rows_shown(d.mesh, of_bodies, d.view.camera);
  d.view.top = rows.top;
  d.height = rows.bottom - rows.top;
  d.contour = contour_step(d.mesh);
  if (!scene.note.empty()) d.top = 68;
  // Up to one and a half pixels for one of the page, and two samples across each of them.
  d.view.scale = 2 * std::clamp(std::sqrt(max_scene_pixels / (picture_width * d.height)), 1.0, 1.5);
  return d;
}

}  // namespace

LookDirection scene_direction(const ScenePicture& scene, const Raster& elevation,
                              const Raster& depth) {
  return direction_for(scene, {elevation, depth, depth, scene.threshold});
}

std::string scene_svg(const ScenePicture& scene, const Raster& elevation, const Raster& depth,
                      const Raster& values) {
  const Drawing d = drawing_of(scene, {elevation, depth, values, scene.threshold});
  // An even number of samples; the scale fits it to less than a sample.
  DepthCanvas canvas(2 * static_cast<int>(picture_width * d.view.scale / 2),
                     2 * static_cast<int>(d.height * d.view.scale / 2));
  draw_mesh(canvas, d.mesh, d.view);
  for (const SceneBody& body : d.bodies)
    draw_body(canvas, body, d.mesh, d.view, light_for(d.direction));

  const double top_value = scene.top.value_or(greatest_value(d.mesh));
  const double page_height = d.top + d.height + 76;
  std::string svg = svg_begin(picture_width + 2 * scene_margin, page_height, scene.title);
  svg += svg_text(scene_margin, 30, scene.title, {.size = 18, .colour = svg_ink, .bold = true});
  if (!scene.note.empty()) svg += svg_text(scene_margin, 52, scene.note, {.size = 13});
  svg += draw_picture(d, canvas, top_value);
  const ScenePage page{d.mesh, canvas, d.view, scene_margin, d.top, picture_width, d.height};
  SceneLabels labels(page);
  for (const SceneBody& body : d.bodies) label_body(page, body, labels);
  for (const MapLine& line : scene.lines) svg += draw_draped(page, line, labels);
  svg += labels.svg();
  if (top_value > 0) {
    svg += svg_colour_bar(scene_margin, d.top + d.height + 34, scene.quantity, top_value);
  }
  return svg + draw_scale(d, d.top + d.height + 40) + "</svg>\n";
}

}  // namespace sabo
