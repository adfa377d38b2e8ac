#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace sabo {

/// A name as one would type it in a shell: as it is, or in quotes where it holds more than letters
/// of any language, digits and the likes of ./_-
inline std::string shell_word(const std::string& name) {
  const auto is_plain = [](unsigned char c) {
    return c >= 0x80 || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
           (c >= '0' && c <= '9') ||
           std::string_view("./_-+=:,@%").find(static_cast<char>(c)) != std::string_view::npos;
  };
  if (!name.empty() && std::ranges::all_of(name, is_plain)) return name;
  std::string word = "'";
  for (const char c : name) {
    if (c == '\'')
      word += "'\\''";
    else
      word += c;
  }
  return word + "'";
}

}  // namespace sabo
