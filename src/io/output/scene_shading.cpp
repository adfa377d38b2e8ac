#include "io/output/scene_shading.hpp"

#include <algorithm>
#include <cmath>

#include "io/output/colour_scale.hpp"

namespace sabo {
namespace {

constexpr Colour sky{247, 248, 249};
constexpr Colour earth_colour{150, 156, 162};
constexpr Colour wall_colour{178, 58, 44};
constexpr Colour black{0, 0, 0};

// Darker than on a map, which has no slopes that face away: brightness 0.85, flat ground, is 205.
Colour scene_ground_colour(double shade) { return ground_colour(0.95 * std::pow(shade, 1.5)); }

Colour surface_colour(const CanvasSample& sample, const SceneColours& colours) {
  const double shade = std::clamp<double>(sample.shade, 0, 1);
  switch (sample.shown) {
    case Shown::ground:
      return scene_ground_colour(shade);
    case Shown::flow:
      // A quarter of the relief shines through.
      return mixed(flow_colour(sample.value / colours.top), scene_ground_colour(shade), 0.25);
    case Shown::wall:
      return mixed(wall_colour, black, 0.6 * (1 - shade));
    case Shown::earth:
      return earth_colour;
    case Shown::nothing:
      break;
  }
  return sky;
}

// How dark the line between two neighbouring samples is, 0 to 1.
double line_between(const CanvasSample& a, const CanvasSample& b, const SceneColours& colours) {
  if (a.shown != b.shown) return 0.6;
  if (a.shown == Shown::nothing || a.shown == Shown::earth) return 0;
  if (a.shown == Shown::wall) return std::abs(a.shade - b.shade) > 0.02f ? 0.4 : 0;
  // One slope in front of another.
  const float nearer = std::max(a.nearness, b.nearness);
  if (std::abs(a.nearness - b.nearness) > 0.025f * nearer) return 0.35;
  const bool is_contour = a.shown == Shown::ground && std::floor(a.elevation / colours.contour) !=
                                                          std::floor(b.elevation / colours.contour);
  return is_contour ? 0.35 : 0;
}

Colour sample_colour(const DepthCanvas& canvas, int column, int row, const SceneColours& colours) {
  const CanvasSample& sample = canvas.at(column, row);
  double line = 0;
  if (column > 0) line = line_between(sample, canvas.at(column - 1, row), colours);
  if (row > 0) line = std::max(line, line_between(sample, canvas.at(column, row - 1), colours));
  const Colour colour = surface_colour(sample, colours);
  return line > 0 ? mixed(colour, ground_line_colour, line) : colour;
}

}  // namespace

Image shaded(const DepthCanvas& canvas, const SceneColours& colours) {
  Image image{canvas.width() / 2, canvas.height() / 2, {}};
  image.pixels.reserve(static_cast<std::size_t>(image.width) * image.height);
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column) {
      std::array<int, 3> sum{};
      for (int k = 0; k < 4; ++k) {
        const Colour colour = sample_colour(canvas, 2 * column + k % 2, 2 * row + k / 2, colours);
        for (std::size_t c = 0; c < 3; ++c) sum[c] += colour[c];
      }
      Colour mean{};
      for (std::size_t c = 0; c < 3; ++c) mean[c] = static_cast<std::uint8_t>((sum[c] + 2) / 4);
      image.pixels.push_back(mean);
    }
  }
  return image;
}

}  // namespace sabo
