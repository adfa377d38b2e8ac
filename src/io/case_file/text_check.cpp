#include "io/case_file/text_check.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace sabo {
namespace {

constexpr std::size_t max_bytes = 1'000'000;
constexpr int max_dots = 200;  // of keys in one line

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Bytes of the UTF-8 sequence at the start of `text` (RFC 3629), 0 when there is none.
std::size_t sequence_length(std::string_view text) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
  };
  const unsigned lead = byte(0);
  if (lead < 0x80) return 1;
  const std::size_t length = lead < 0xC2   ? 0
                             : lead < 0xE0 ? 2
                             : lead < 0xF0 ? 3
                             : lead < 0xF5 ? 4
                                           : 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0u) != 0x80) return 0;
  }
  // Overlong forms, surrogates and values above U+10FFFF show in the second byte.
  const unsigned second = byte(1);
  const bool is_wrong = (lead == 0xE0 && second < 0xA0) || (lead == 0xED && second > 0x9F) ||
                        (lead == 0xF0 && second < 0x90) || (lead == 0xF4 && second > 0x8F);
  return is_wrong ? 0 : length;
}

/// Dots that cannot belong to a number: none in "1.5", one in "a.b" and in "1.2.3". They bound the
/// depth of the tables that a line makes.
int count_key_dots(std::string_view line) {
  int count = 0;
  bool follows_dot = false;  // the run of digits that ends here began after a dot
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '.') {
      const bool is_in_number = !follows_dot && i > 0 && is_digit(line[i - 1]) &&
                                i + 1 < line.size() && is_digit(line[i + 1]);
      if (!is_in_number) ++count;
      follows_dot = true;
    } else if (!is_digit(line[i])) {
      follows_dot = false;
    }
  }
  return count;
}

/// Problem and remedy of one line, without its number.
std::optional<UnfitText> find_unfit_line(std::string_view line) {
  for (std::size_t i = 0; i < line.size();) {
    const std::size_t length = sequence_length(line.substr(i));
    const unsigned byte = static_cast<unsigned char>(line[i]);
    if (length == 0) {
      return UnfitText{0, fmt::format("byte 0x{:02x} is not UTF-8", byte),
                       "save the file as UTF-8"};
    }
    const bool is_line_end = line[i] == '\r' && i + 1 == line.size();
    if (is_control(line[i]) && line[i] != '\t' && !is_line_end) {
      return UnfitText{0, fmt::format("control character 0x{:02x}", byte), "remove it"};
    }
    i += length;
  }
  if (count_key_dots(line) > max_dots) {
    return UnfitText{0, fmt::format("more than {} dots in one line", max_dots), "shorten the line"};
  }
  return std::nullopt;
}

}  // namespace

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = sequence_length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

std::optional<UnfitText> find_unfit_text(std::string_view text) {
  if (text.size() > max_bytes) {
    return UnfitText{0, "larger than 1 MB", "give long lines as vector files, not as coordinates"};
  }
  std::size_t number = 1;
  for (std::size_t begin = 0; begin < text.size(); ++number) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    if (auto unfit = find_unfit_line(text.substr(begin, end - begin))) {
      unfit->line = number;
      return unfit;
    }
    begin = end + 1;
  }
  return std::nullopt;
}

}  // namespace sabo
