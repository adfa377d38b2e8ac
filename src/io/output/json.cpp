#include "io/output/json.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/utf8.hpp"

namespace sabo {

std::string json_string(std::string_view text) {
  std::string out = "\"";
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text, i);
    const std::string_view character = text.substr(i, length);
    const auto code = static_cast<unsigned char>(text[i]);
    // U+2028 and U+2029 ended a line of JavaScript before 2019.
    if (length == 0) {
      out += "\\ufffd";
    } else if (character == "\xE2\x80\xA8" || character == "\xE2\x80\xA9" || code < 0x20 ||
               code == 0x7F) {
      out += ' ';
    } else if (text[i] == '"' || text[i] == '\\') {
      out += {'\\', text[i]};
    } else if (text[i] == '<' || text[i] == '>' || text[i] == '&') {
      out += fmt::format("\\u{:04x}", code);
    } else {
      out += character;
    }
    i += std::max<std::size_t>(length, 1);
  }
  return out + '"';
}

std::string json_number(double value) {
  return std::isfinite(value) ? fmt::format("{:.6g}", value) : "null";
}

}  // namespace sabo
