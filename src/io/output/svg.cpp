#include "io/output/svg.hpp"

#include <array>

#include <fmt/format.h>

#include "io/output/markup.hpp"

namespace sabo {

std::string svg_begin(double width, double height, std::string_view title) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
      "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"{2}\" role=\"img\">\n"
      "<title>{3}</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
      width, height, svg_font, escaped(title));
}

std::string svg_text(double x, double y, std::string_view text, const TextStyle& style) {
  constexpr std::array anchors{"start", "middle", "end"};
  return fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{}\" fill=\"{}\" text-anchor=\"{}\"{}{}>{}"
      "</text>\n",
      x, y, style.size, style.colour, anchors[static_cast<std::size_t>(style.anchor)],
      style.bold ? " font-weight=\"600\"" : "",
      style.halo ? " stroke=\"#ffffff\" stroke-width=\"3\" stroke-linejoin=\"round\" "
                   "paint-order=\"stroke\""
                 : "",
      escaped(text));
}

std::string svg_line(double x1, double y1, double x2, double y2, const char* colour, double width) {
  return fmt::format(
      "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" "
      "stroke-width=\"{}\"/>\n",
      x1, y1, x2, y2, colour, width);
}

std::vector<std::string> wrapped(std::string_view text, double size, double width) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(text.size(), word.size() + 1));
    const bool fits =
        !lines.empty() &&
        text_width(lines.back(), size) + text_width(" ", size) + text_width(word, size) <= width;
    if (fits) {
      lines.back().append(" ").append(word);
    } else {
      lines.emplace_back(word);
    }
  }
  return lines;
}

double text_width(std::string_view text, double size) {
  double width = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool starts_character = (byte & 0xC0) != 0x80;
    const bool is_wide = byte >= 0xE3;  // from U+3000 on: kana, kanji, hangul
    if (starts_character) width += is_wide ? 1 : 0.56;
  }
  return width * size;
}

}  // namespace sabo
