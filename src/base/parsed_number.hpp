#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace sabo {

/// A text that is a number from its first to its last character, whatever the locale; floating
/// numbers may be infinite or NaN. Nothing for another text and for a number out of range.
template <class Number>
std::optional<Number> parsed_number(std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// The same, but finite.
template <class Number>
std::optional<Number> finite_number(std::string_view text) {
  const auto number = parsed_number<Number>(text);
  if constexpr (std::is_floating_point_v<Number>)
    if (number && !std::isfinite(*number)) return std::nullopt;
  return number;
}

}  // namespace sabo
