#include "io/output/colour_scale.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace sabo {
namespace {

// Viridis (S. van der Walt and N. Smith, 2015, CC0) at nine even steps, light to dark.
constexpr std::array<Colour, 9> viridis{{{253, 231, 37},
                                         {173, 220, 48},
                                         {94, 201, 98},
                                         {40, 174, 128},
                                         {33, 145, 140},
                                         {44, 114, 142},
                                         {59, 82, 139},
                                         {71, 44, 122},
                                         {68, 1, 84}}};

}  // namespace

Colour flow_colour(double fraction) {
  const double place = (fraction > 0 ? std::min(fraction, 1.0) : 0.0) * (viridis.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), viridis.size() - 2);
  const double t = place - static_cast<double>(below);
  Colour colour{};
  for (std::size_t c = 0; c < 3; ++c) {
    colour[c] = static_cast<std::uint8_t>(
        std::lround((1 - t) * viridis[below][c] + t * viridis[below + 1][c]));
  }
  return colour;
}

Colour ground_colour(double shade) {
  const auto grey = static_cast<std::uint8_t>(std::lround(60 + 195 * shade));
  return {grey, grey, grey};
}

Colour mixed(const Colour& a, const Colour& b, double share_of_b) {
  Colour out{};
  for (std::size_t c = 0; c < 3; ++c) {
    out[c] = static_cast<std::uint8_t>(std::lround((1 - share_of_b) * a[c] + share_of_b * b[c]));
  }
  return out;
}

Colour step_colour(std::span<const ColourStep> steps, double value) {
  const auto in_class = [value](const ColourStep& step) { return value < step.end; };
  const auto found = std::find_if(steps.begin(), steps.end() - 1, in_class);
  return found->colour;
}

std::vector<ColourStep> difference_steps(double top) {
  constexpr std::array<Colour, 7> colours{{{69, 117, 180},
                                           {145, 191, 219},
                                           {224, 243, 248},
                                           {255, 255, 191},
                                           {254, 224, 144},
                                           {252, 141, 89},
                                           {215, 48, 39}}};
  const std::array bounds{-top, -0.3 * top, -0.1 * top, 0.1 * top, 0.3 * top, top};
  std::vector<ColourStep> steps;
  for (std::size_t k = 0; k < colours.size(); ++k) {
    ColourStep step{k < bounds.size() ? bounds[k] : 0, colours[k]};
    if (k == 0) {
      step.label = fmt::format("below {:g}", bounds.front());
    } else if (k == bounds.size()) {
      step.label = fmt::format("above {:g}", bounds.back());
    } else {
      step.label = fmt::format("{:g} to {:g}", bounds[k - 1], bounds[k]);
    }
    steps.push_back(std::move(step));
  }
  return steps;
}

std::string hex(const Colour& colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", colour[0], colour[1], colour[2]);
}

}  // namespace sabo
