#include "io/output/markup.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>

#include <fmt/format.h>

#include "base/utf8.hpp"

namespace sabo {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";  // U+FFFD

std::string_view escape_of(std::string_view character) {
  switch (character.front()) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    case '\n':
    case '\t':
      return character;
    default:
      break;
  }
  const auto code = static_cast<unsigned char>(character.front());
  const bool is_forbidden = character == "\xEF\xBF\xBE" || character == "\xEF\xBF\xBF";  // by XML
  return code < 0x20 || code == 0x7F || is_forbidden ? replacement : character;
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text, i);
    out += length == 0 ? replacement : escape_of(text.substr(i, length));
    i += std::max<std::size_t>(length, 1);
  }
  return out;
}

std::string url_of(std::string_view path) {
  std::string out;
  for (char c : path) {
    const auto code = static_cast<unsigned char>(c);
    const bool is_plain =
        code < 0x80 && (std::isalnum(code) || std::string_view("-._~/").find(c) != path.npos);
    out += is_plain ? std::string(1, c) : fmt::format("%{:02X}", code);
  }
  return out;
}

}  // namespace sabo
