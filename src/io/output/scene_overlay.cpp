#include "io/output/scene_overlay.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "io/output/svg.hpp"

namespace sabo {
namespace {

constexpr double label_size = 13;

// Points of a line at about every mesh of the surface, NaN heights left in as gaps.
std::vector<Vec3d> laid_on(const SceneMesh& mesh, const Polyline& line) {
  constexpr double most_parts = 4000;
  const double whole = length(line);
  if (!(whole > 0) || !std::isfinite(whole)) return {};
  const double parts = std::clamp(std::ceil(whole / mesh.spacing()), 1.0, most_parts);
  std::vector<Vec3d> points;
  for (int i = 0; i <= static_cast<int>(parts); ++i) {
    Vec3d point = point_at(line, whole * i / parts);
    // A little above the surface, whose triangles run straight between its corners.
    point.z = mesh.drawn(mesh.height(point.x, point.y) + 0.1 * mesh.spacing());
    points.push_back(point);
  }
  return points;
}

}  // namespace

PagePoint page_point(const ScenePage& page, const Vec3d& point) {
  const CanvasCorner corner = page.view.corner(point);
  if (!(corner.nearness > 0) || !std::isfinite(corner.x) || !std::isfinite(corner.y)) return {};
  return {page.left + corner.x / page.view.scale, page.top + corner.y / page.view.scale,
          page.canvas.shows(corner.x, corner.y, corner.nearness)};
}

bool SceneLabels::is_free(const Box& box) const {
  const bool is_inside = box.left >= page_.left + 2 && box.right <= page_.left + page_.width - 2 &&
                         box.top >= page_.top + 2 && box.bottom <= page_.top + page_.height - 2;
  return is_inside && std::ranges::none_of(taken_, [&box](const Box& other) {
           return box.left < other.right && other.left < box.right && box.top < other.bottom &&
                  other.top < box.bottom;
         });
}

void SceneLabels::add(std::string_view text, const char* colour, std::vector<PagePoint> places) {
  std::erase_if(places, [](const PagePoint& place) { return !place.is_seen; });
  std::ranges::stable_sort(places, {}, &PagePoint::y);
  const double width = text_width(text, label_size) + 8;
  for (const double rise : {9.0, 32.0, 54.0}) {
    for (const PagePoint& place : places) {
      const double bottom = place.y - rise + 5;
      const Box box{place.x - width / 2, bottom - label_size - 5, place.x + width / 2, bottom};
      if (!is_free(box)) continue;
      taken_.push_back(box);
      if (bottom < place.y - 8) svg_ += svg_line(place.x, place.y, place.x, bottom - 1, colour, 1);
      svg_ += svg_text(place.x, place.y - rise, text,
                       {.size = label_size,
                        .colour = colour,
                        .anchor = Anchor::middle,
                        .bold = true,
                        .halo = true});
      return;
    }
  }
}

std::string draw_draped(const ScenePage& page, const MapLine& line, SceneLabels& labels) {
  std::string path;
  std::vector<PagePoint> seen;
  bool is_down = false;
  for (const Vec3d& point : laid_on(page.mesh, line.line)) {
    const PagePoint place = page_point(page, point);
    if (!place.is_seen) {
      is_down = false;
      continue;
    }
    if (is_down && std::hypot(place.x - seen.back().x, place.y - seen.back().y) < 1) continue;
    path += fmt::format("{}{:.1f} {:.1f}", is_down ? "L" : "M", place.x, place.y);
    seen.push_back(place);
    is_down = true;
  }
  if (seen.empty()) return "";
  const LineStyle style = style_of(line.kind);
  if (!line.label.empty()) labels.add(line.label, style.colour, {seen.front(), seen.back()});
  const auto stroke = [&path](const char* colour, double width, const char* dashes) {
    return fmt::format(
        "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"{} "
        "stroke-linejoin=\"round\"/>\n",
        path, colour, width, dashes);
  };
  return stroke("#ffffff", style.width + 1.4, " stroke-opacity=\"0.6\"") +
         stroke(style.colour, style.width, style.dashes);
}

}  // namespace sabo
