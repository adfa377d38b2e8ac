#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace sabo {

using Colour = std::array<std::uint8_t, 3>;

/// Viridis from its light end (0: yellow) to its dark end (1: violet): even to the eye, in the same
/// order in grey and with any colour vision, visible on a grey hillshade. Clamped to [0, 1]; NaN
/// counts as 0.
Colour flow_colour(double fraction);

/// "#rrggbb"
std::string hex(const Colour& colour);

}  // namespace sabo
