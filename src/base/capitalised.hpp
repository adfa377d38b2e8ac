#pragma once

#include <string>

namespace sabo {

/// The text with its first letter, if it is one of ASCII, as a capital.
inline std::string capitalised(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 32);
  return text;
}

}  // namespace sabo
