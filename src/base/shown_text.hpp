#pragma once

#include <cctype>
#include <string>
#include <string_view>

namespace sabo {

/// For messages: whatever a file holds, a short line of plain characters.
inline std::string shown_text(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string line(text.substr(0, longest));
  for (char& c : line) {
    if (!std::isprint(static_cast<unsigned char>(c))) c = '?';
  }
  return text.size() > longest ? line + "..." : line;
}

}  // namespace sabo
