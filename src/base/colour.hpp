#pragma once

#include <array>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>
#include <system_error>

namespace sabo {

using Colour = std::array<std::uint8_t, 3>;

/// The colour of "#rrggbb"; nothing for another text.
inline std::optional<Colour> colour_of(std::string_view text) {
  Colour colour{};
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  for (std::size_t c = 0; c < colour.size(); ++c) {
    const char* first = text.data() + 1 + 2 * c;
    const auto [stop, error] = std::from_chars(first, first + 2, colour[c], 16);
    if (error != std::errc() || stop != first + 2) return std::nullopt;
  }
  return colour;
}

}  // namespace sabo
