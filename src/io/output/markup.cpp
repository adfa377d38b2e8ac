#include "io/output/markup.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>

#include <fmt/format.h>

namespace sabo {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";  // U+FFFD

unsigned byte_at(std::string_view text, std::size_t i) {
  return static_cast<unsigned char>(text[i]);
}

// Bytes of the character at i; 0 when they are not well-formed UTF-8 (Unicode 15, table 3-7) or
// are one of the two codes that XML forbids.
std::size_t length_at(std::string_view text, std::size_t i) {
  const unsigned first = byte_at(text, i);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || i + length > text.size()) return 0;
  const unsigned second = byte_at(text, i + 1);
  const unsigned low = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
  const unsigned high = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
  if (second < low || second > high) return 0;
  for (std::size_t k = 2; k < length; ++k) {
    if ((byte_at(text, i + k) & 0xC0) != 0x80) return 0;
  }
  const bool is_forbidden = first == 0xEF && second == 0xBF && byte_at(text, i + 2) >= 0xBE;
  return is_forbidden ? 0 : length;
}

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
  return code < 0x20 || code == 0x7F ? replacement : character;
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = length_at(text, i);
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
