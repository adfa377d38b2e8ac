#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/colour.hpp"

namespace sabo {

/// Viridis from its light end (0: yellow) to its dark end (1: violet): even to the eye, in the same
/// order in grey and with any colour vision, visible on a grey hillshade. Clamped to [0, 1]; NaN
/// counts as 0.
Colour flow_colour(double fraction);

/// Grey of the ground from its brightness (0: turned away from the light, 1: facing it). Flat
/// ground is light, so that colours and lines stand out.
Colour ground_colour(double shade);

/// Lines on the ground: contours, and edges of what stands on it.
inline constexpr Colour ground_line_colour{60, 72, 84};

/// From `a` (share 0) to `b` (share 1).
Colour mixed(const Colour& a, const Colour& b, double share_of_b);

/// One class of a stepped scale: values from the end of the class before it (the first: from any)
/// to below `end`; the last class has no end.
struct ColourStep {
  double end = 0;
  Colour colour{};
  std::string label = {};
};

/// Seven classes around zero for differences, symmetric about it, from blue (less) over pale
/// yellow, which a grey hillshade does not have, to red (more) in the colours of ColorBrewer's
/// RdYlBu, which any colour vision tells apart. Their bounds are a tenth, three tenths and the
/// whole of `top` (> 0).
std::vector<ColourStep> difference_steps(double top);

/// Colour of the class that holds the value; `steps` is not empty.
Colour step_colour(std::span<const ColourStep> steps, double value);

/// "#rrggbb"
std::string hex(const Colour& colour);

}  // namespace sabo
