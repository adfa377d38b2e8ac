#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string_view>
#include <type_traits>

namespace sabo {

/// What a user may set, said once: the case reader, `sabo check --defaults`, `sabo models`, the
/// resolved case and the documentation all come from it.
///
/// A struct offers `template <class V> void describe(V&& v)`, which calls `v(key, member)` for each
/// member in the order of the documentation. The member's initial value is the default.
struct Key {
  std::string_view name;
  std::string_view unit;  ///< "" when there is none
  std::string_view help;  ///< one line, no full stop
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool min_is_open = false;  ///< the value must be greater than min, not equal to it
  bool is_required = false;

  /// value > bound
  constexpr Key above(double bound) const {
    Key key = *this;
    key.min = bound;
    key.min_is_open = true;
    return key;
  }
  /// value >= bound
  constexpr Key at_least(double bound) const {
    Key key = *this;
    key.min = bound;
    return key;
  }
  /// value <= bound
  constexpr Key at_most(double bound) const {
    Key key = *this;
    key.max = bound;
    return key;
  }
  constexpr Key required() const {
    Key key = *this;
    key.is_required = true;
    return key;
  }
  /// Whether the value is in the range; false for NaN.
  constexpr bool accepts(double value) const {
    return (min_is_open ? value > min : value >= min) && value <= max;
  }
};

/// A struct with a describe() as above.
template <class T>
concept Described = requires(T& described) {
  described.describe(0);
};

/// Visitors that set what they visit say so (`static constexpr bool sets_members = true`): only for
/// them one member may decide the default of another.
template <class V>
concept SetsMembers = requires {
  requires std::remove_reference_t<V>::sets_members;
};

/// The words of an enumeration in the order of its values; each enum that a user may set
/// specialises this: `template <> struct Words<Colour> { static constexpr std::array list{...}; };`
template <class Enum>
struct Words;

template <class Enum>
constexpr std::string_view word_of(Enum value) {
  return Words<Enum>::list[static_cast<std::size_t>(value)];
}

/// The value that a word stands for, or nothing.
template <class Enum>
constexpr std::optional<Enum> value_of_word(std::string_view word) {
  for (std::size_t k = 0; k < Words<Enum>::list.size(); ++k)
    if (Words<Enum>::list[k] == word) return static_cast<Enum>(k);
  return std::nullopt;
}

}  // namespace sabo
