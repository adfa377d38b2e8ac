#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

#include "base/describe.hpp"
#include "case/case.hpp"

namespace sabo {

/// A number of at most six digits: "60", "1e9", "1e-6".
std::string short_text(double number);

/// The range of a number with its unit: "from 0 to 60 deg", "above 0, at most 10000 m".
std::string range_text(const Key& key);

/// `own, mirror, none`.
std::string list_text(const std::vector<std::string>& words);

/// `"own", "mirror" or "none"`.
std::string words_text(const std::vector<std::string>& words);

/// The names of all rheologies, and of all material presets.
std::vector<std::string> rheology_names();
std::vector<std::string> preset_names();

template <class Enum>
std::vector<std::string> words_of() {
  return {Words<Enum>::list.begin(), Words<Enum>::list.end()};
}

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

template <class T>
concept OptionalTable = is_optional<T> && Described<typename T::value_type>;

template <class T>
inline constexpr std::size_t numbers_in = 0;
template <std::size_t n>
inline constexpr std::size_t numbers_in<std::array<double, n>> = n;

/// What a user may write for a key whose member is a T: "a number from 0 to 60 deg".
template <class T>
std::string wanted_text(const Key& key) {
  if constexpr (OptionalTable<T>) {
    return "a table";
  } else if constexpr (is_optional<T>) {
    return wanted_text<typename T::value_type>(key);
  } else if constexpr (std::is_same_v<T, bool>) {
    return "true or false";
  } else if constexpr (std::is_same_v<T, int>) {
    return "a whole number " + range_text(key);
  } else if constexpr (std::is_same_v<T, double>) {
    return "a number " + range_text(key);
  } else if constexpr (numbers_in<T> > 0) {
    return fmt::format("[{} numbers], each {}", numbers_in<T>, range_text(key));
  } else if constexpr (std::is_same_v<T, std::string>) {
    return "text in quotes";
  } else if constexpr (std::is_same_v<T, std::filesystem::path>) {
    return "a file name in quotes";
  } else if constexpr (std::is_same_v<T, LineSource>) {
    return "a file name in quotes or points [[x, y], [x, y], ...]";
  } else if constexpr (std::is_same_v<T, Rheology>) {
    return words_text(rheology_names());
  } else if constexpr (std::is_same_v<T, PresetName>) {
    return words_text(preset_names());
  } else {
    static_assert(std::is_enum_v<T>, "a type that the case file does not know");
    return words_text(words_of<T>());
  }
}

}  // namespace sabo
