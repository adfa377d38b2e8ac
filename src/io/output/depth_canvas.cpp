#include "io/output/depth_canvas.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sabo {
namespace {

// How much nearer a surface must be to hide a point, as a share of the distance: points that lie on
// the surface itself show.
constexpr double hiding_share = 0.003;

// Wetness from which a place is flow: most of the slope between a corner with flow, which is
// lifted, and one without.
constexpr float flow_edge = 0.25f;

// Twice the area, positive when the corners go clockwise on the picture (y points down).
double area_of(const CanvasCorner& a, const CanvasCorner& b, const CanvasCorner& c) {
  return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
}

}  // namespace

DepthCanvas::DepthCanvas(int width, int height)
    : width_(width), height_(height), samples_(static_cast<std::size_t>(width) * height) {}

template <class ShownAt>
void DepthCanvas::draw(const std::array<const CanvasCorner*, 3>& corners, ShownAt&& shown_at) {
  const CanvasCorner &a = *corners[0], &b = *corners[1], &c = *corners[2];
  const double area = area_of(a, b, c);
  const auto [left, right] = std::minmax({a.x, b.x, c.x});
  const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
  const bool is_outside = !(right >= 0 && left <= width_ && bottom >= 0 && top <= height_);
  if (is_outside || area == 0 || !std::isfinite(area)) return;
  // Samples are the middles of their squares.
  const int first_column = static_cast<int>(std::ceil(std::max(left - 0.5, 0.0)));
  const int last_column = static_cast<int>(std::floor(std::min(right - 0.5, width_ - 1.0)));
  const int first_row = static_cast<int>(std::ceil(std::max(top - 0.5, 0.0)));
  const int last_row = static_cast<int>(std::floor(std::min(bottom - 0.5, height_ - 1.0)));
  for (int row = first_row; row <= last_row; ++row) {
    for (int column = first_column; column <= last_column; ++column) {
      const double x = column + 0.5, y = row + 0.5;
      const double wa = ((b.x - x) * (c.y - y) - (c.x - x) * (b.y - y)) / area;
      const double wb = ((c.x - x) * (a.y - y) - (a.x - x) * (c.y - y)) / area;
      const double wc = 1 - wa - wb;
      // A little beyond the edges, so that rounding leaves no gap between two triangles.
      if (std::min({wa, wb, wc}) < -1e-9) continue;
      const double nearness = wa * a.nearness + wb * b.nearness + wc * c.nearness;
      CanvasSample& sample = samples_[static_cast<std::size_t>(row) * width_ + column];
      if (!(nearness > sample.nearness)) continue;
      // Lengths on a plane in perspective go with the nearness.
      const auto pa = static_cast<float>(wa * a.nearness / nearness);
      const auto pb = static_cast<float>(wb * b.nearness / nearness);
      const float pc = 1 - pa - pb;
      const float wetness = pa * a.wetness + pb * b.wetness + pc * c.wetness;
      sample = {static_cast<float>(nearness), pa * a.shade + pb * b.shade + pc * c.shade,
                pa * a.value + pb * b.value + pc * c.value,
                pa * a.elevation + pb * b.elevation + pc * c.elevation, shown_at(wetness)};
    }
  }
}

void DepthCanvas::draw_ground(const CanvasCorner& a, const CanvasCorner& b, const CanvasCorner& c) {
  const bool is_seen_from_below = area_of(a, b, c) > 0;
  draw({&a, &b, &c}, [is_seen_from_below](float wetness) {
    if (is_seen_from_below) return Shown::earth;
    return wetness > flow_edge ? Shown::flow : Shown::ground;
  });
}

void DepthCanvas::draw_solid(const CanvasCorner& a, const CanvasCorner& b, const CanvasCorner& c,
                             Shown shown) {
  draw({&a, &b, &c}, [shown](float) { return shown; });
}

bool DepthCanvas::shows(double x, double y, double nearness) const {
  if (!(x >= 0 && x < width_ && y >= 0 && y < height_)) return false;
  const int column = static_cast<int>(x), row = static_cast<int>(y);
  float farthest = std::numeric_limits<float>::infinity();
  for (int r = std::max(row - 1, 0); r <= std::min(row + 1, height_ - 1); ++r) {
    for (int c = std::max(column - 1, 0); c <= std::min(column + 1, width_ - 1); ++c) {
      farthest = std::min(farthest, at(c, r).nearness);
    }
  }
  return nearness >= farthest * (1 - hiding_share);
}

}  // namespace sabo
