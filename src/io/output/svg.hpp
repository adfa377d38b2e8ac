#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sabo {

// What every picture has in common, so that they look like one family.
inline constexpr const char* svg_font =
    "system-ui, -apple-system, 'Segoe UI', Roboto, 'Helvetica Neue', Arial, sans-serif";
inline constexpr const char* svg_ink = "#1f2933";    // titles, lines of structures
inline constexpr const char* svg_muted = "#52606d";  // labels
inline constexpr const char* svg_light = "#e4e7eb";  // grid lines

enum class Anchor { start, middle, end };

struct TextStyle {
  double size = 12;
  const char* colour = svg_muted;
  Anchor anchor = Anchor::start;
  bool bold = false;
  bool halo = false;  ///< white outline, for text on a map
};

/// Opening tag of a picture with a white background and a title for screen readers.
std::string svg_begin(double width, double height, std::string_view title);

/// One line of text, its baseline at y; escaped here.
std::string svg_text(double x, double y, std::string_view text, const TextStyle& style = {});

std::string svg_line(double x1, double y1, double x2, double y2, const char* colour, double width);

/// Lines of a text that is broken at spaces to fit a width, pixels; a longer word stays whole.
std::vector<std::string> wrapped(std::string_view text, double size, double width);

/// Estimated width of a text, pixels; exact widths depend on the reader's font.
double text_width(std::string_view text, double size);

}  // namespace sabo
