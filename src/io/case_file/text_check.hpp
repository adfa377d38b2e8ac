#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace sabo {

struct UnfitText {
  std::size_t line = 0;  ///< counted from 1; 0 for the whole text
  std::string problem;
  std::string remedy;
};

inline constexpr std::size_t largest_text = 1'000'000;  ///< bytes, of what a user writes
/// Of a case that sabo wrote from one, with the help of each key.
inline constexpr std::size_t largest_written_case = 4 * largest_text;

/// What makes a text unfit for the TOML parser, which does not stand every input: a great size,
/// bytes that are not UTF-8, control characters, very deep keys. Nothing when it is fit.
std::optional<UnfitText> find_unfit_text(std::string_view text,
                                         std::size_t most_bytes = largest_text);

bool is_utf8(std::string_view text);

/// Whether a character is none of a text in one line; 0x7f is DEL.
constexpr bool is_control(char c) { return (c >= 0 && c < 0x20) || c == 0x7f; }

}  // namespace sabo
