#include "io/case_file/text_check.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/utf8.hpp"

namespace sabo {
namespace {

constexpr int max_dots = 200;  // of keys in one line

bool is_digit(char c) { return c >= '0' && c <= '9'; }

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
    const std::size_t length = utf8_length(line, i);
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
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text, i);
    if (length == 0) return false;
    i += length;
  }
  return true;
}

std::optional<UnfitText> find_unfit_text(std::string_view text, std::size_t most_bytes) {
  if (text.size() > most_bytes) {
    return UnfitText{0, fmt::format("larger than {} MB", most_bytes / 1'000'000),
                     "give long lines as vector files, not as coordinates"};
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
