#include "io/output/map_picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "io/output/svg.hpp"
#include "io/output/svg_colour_bar.hpp"
#include "io/output/ticks.hpp"
#include "terrain/bilinear.hpp"

namespace sabo {
namespace {

constexpr double narrowest = 640;    // px, so that the legend has room
constexpr double scale_width = 260;  // px, of scale bar and north arrow beside a legend
constexpr double margin = 20;        // px
constexpr double title_size = 18;    // px
constexpr double bold = 1.12;        // width of bold text over that of plain text
constexpr double title_line = 24;    // px
constexpr double note_size = 13;     // px
constexpr double note_line = 20;     // px
constexpr const char* solid_colour = "#d9c5c0";
constexpr double max_pixels = 1.5e6;  // of the embedded picture

// Where things stand on the picture.
struct Layout {
  MapView view;
  double scale = 1;  // px per metre
  double left = margin;
  double top = 0;
  double width = 0;
  double height = 0;
  double page_width = 0;
  double page_height = 0;
  std::vector<std::string> title, note;  // in lines

  double title_y(std::size_t line) const { return 30 + title_line * static_cast<double>(line); }
  double note_y(std::size_t line) const {
    const std::size_t titles = std::max<std::size_t>(1, title.size());
    return title_y(titles - 1) + 22 + note_line * static_cast<double>(line);
  }
  double x(double east) const { return left + (east - view.west) * scale; }
  double y(double north) const { return top + (view.north - north) * scale; }
};

// A view so narrow that its labels would not fit is widened about its middle.
MapView not_too_narrow(MapView view) {
  const double shortest = std::max(view.east - view.west, view.north - view.south) / 40;
  const auto widen = [shortest](double& low, double& high) {
    const double missing = std::max(0.0, shortest - (high - low));
    low -= missing / 2;
    high += missing / 2;
  };
  widen(view.west, view.east);
  widen(view.south, view.north);
  return view;
}

Layout layout_of(const MapPicture& map) {
  Layout layout;
  layout.view = not_too_narrow(map.view);
  const double east_west = layout.view.east - layout.view.west;
  const double north_south = layout.view.north - layout.view.south;
  layout.scale = std::min(map.widest / east_west, map.tallest / north_south);
  layout.width = std::round(east_west * layout.scale);
  layout.height = std::round(north_south * layout.scale);
  const double legend = step_bar_width(map.steps) + scale_width;
  layout.page_width = std::max({layout.width, narrowest, legend}) + 2 * margin;
  layout.left = std::round((layout.page_width - layout.width) / 2);
  layout.title = wrapped(map.title, title_size * bold, layout.page_width - 2 * margin);
  layout.note = wrapped(map.note, note_size, layout.page_width - 2 * margin);
  layout.top = layout.note_y(layout.note.size()) - 4;
  layout.page_height = layout.top + layout.height + 76;
  return layout;
}

double greatest(const Raster& values, const MapView& view) {
  double result = 0;
  const Grid& grid = values.grid;
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const double x = grid.x_of(column), y = grid.y_of(row);
      const bool is_shown = x >= view.west && x <= view.east && y >= view.south && y <= view.north;
      if (is_shown) result = std::max(result, values.at(column, row));  // false for NaN
    }
  }
  return result;
}

// About ten contour lines over the relief shown.
double contour_step(const Raster& elevation, const MapView& view) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (int i = 0; i <= 40; ++i) {
    for (int j = 0; j <= 40; ++j) {
      const double z = bilinear(elevation, view.west + i * (view.east - view.west) / 40,
                                view.south + j * (view.north - view.south) / 40, Raster::no_data);
      if (std::isnan(z)) continue;
      low = std::min(low, z);
      high = std::max(high, z);
    }
  }
  return high > low ? round_down((high - low) / 8) : 1;
}

std::string draw_raster(const Relief& relief, const Layout& layout, double sharpness) {
  // Two pixels for one of the page where that is not too much: sharp on any screen.
  const double affordable = std::max(1.0, std::sqrt(max_pixels / (layout.width * layout.height)));
  const double ratio = std::min(affordable, sharpness);
  const Image image = draw_relief(relief, layout.view, static_cast<int>(layout.width * ratio),
                                  static_cast<int>(layout.height * ratio));
  return fmt::format(
      "<image x=\"{0}\" y=\"{1}\" width=\"{2}\" height=\"{3}\" preserveAspectRatio=\"none\" "
      "href=\"{4}\"/>\n<rect x=\"{0}\" y=\"{1}\" width=\"{2}\" height=\"{3}\" fill=\"none\" "
      "stroke=\"#9aa5b1\"/>\n",
      layout.left, layout.top, layout.width, layout.height, data_url_of_png(png_of(image)));
}

// Where the label of a line stands: beside the northern end for sections and the southern end for
// the rest, so that a dam and the sections on either side of it keep apart; of areas inside their
// northern edge, where it hides little.
Vec3d label_place(const MapLine& line, const Layout& layout) {
  const auto& vertices = line.line.vertices;
  const auto [south, north] = std::ranges::minmax_element(vertices, {}, &Vec3d::y);
  switch (line.kind) {
    case MapLine::Kind::zone:
    case MapLine::Kind::edit: {
      const auto [west, east] = std::ranges::minmax(vertices, {}, &Vec3d::x);
      return {layout.x((west.x + east.x) / 2), layout.y(north->y) + 20, 0};
    }
    case MapLine::Kind::section:
    case MapLine::Kind::inflow:
      return {layout.x(north->x), layout.y(north->y) - 7, 0};
    case MapLine::Kind::dam:
    case MapLine::Kind::path:
      break;
  }
  return {layout.x(south->x), layout.y(south->y) + 18, 0};
}

bool is_in_view(const MapLine& line, const MapView& view) {
  const auto& vertices = line.line.vertices;
  const auto [west, east] = std::ranges::minmax(vertices, {}, &Vec3d::x);
  const auto [south, north] = std::ranges::minmax(vertices, {}, &Vec3d::y);
  return east.x > view.west && west.x < view.east && north.y > view.south && south.y < view.north;
}

struct LabelBox {
  double x = 0, y = 0;  // middle of the baseline
  double half = 0;      // of the width
};

constexpr double label_height = 15;  // px

// The label of a line, beside its place if another label stands there; left out where all is full.
std::string draw_label(const MapLine& line, const Layout& layout, std::vector<LabelBox>& taken) {
  if (line.label.empty() || !is_in_view(line, layout.view)) return "";
  constexpr double size = 13;
  const auto kept = [](double place, double low, double high) {
    return std::clamp(place, low, std::max(low, high));
  };
  const double half = 1.12 * text_width(line.label, size) / 2 + 4;  // bold is wider
  const Vec3d place = label_place(line, layout);
  const double x = kept(place.x, layout.left + half, layout.left + layout.width - half);
  for (const double lines : {0, 1, -1, 2, -2, 3, -3}) {
    const double y =
        kept(place.y + lines * label_height, layout.top + 14, layout.top + layout.height - 6);
    const bool is_free = std::ranges::none_of(taken, [&](const LabelBox& other) {
      return std::abs(x - other.x) < half + other.half && std::abs(y - other.y) < label_height;
    });
    if (!is_free) continue;
    taken.push_back({x, y, half});
    return svg_text(x, y, line.label,
                    {.size = size,
                     .colour = style_of(line.kind).colour,
                     .anchor = Anchor::middle,
                     .bold = true,
                     .halo = true});
  }
  return "";
}

// Structures and sections first: areas have room elsewhere.
std::string draw_labels(const MapPicture& map, const Layout& layout) {
  std::vector<LabelBox> taken;
  std::string labels;
  for (const bool is_area : {false, true})
    for (const MapLine& line : map.lines) {
      const bool is_of_area = line.kind == MapLine::Kind::zone || line.kind == MapLine::Kind::edit;
      if (is_of_area == is_area && !line.line.vertices.empty())
        labels += draw_label(line, layout, taken);
    }
  return labels;
}

std::string draw_lines(const MapPicture& map, const Layout& layout) {
  std::string shapes;
  for (const MapLine& line : map.lines) {
    if (line.line.vertices.empty()) continue;
    std::string points;
    for (const Vec3d& v : line.line.vertices) {
      points += fmt::format("{:.1f},{:.1f} ", layout.x(v.x), layout.y(v.y));
    }
    const LineStyle style = style_of(line.kind);
    const auto polyline = [&](const char* colour, double width, const char* dashes) {
      return fmt::format(
          "<polyline points=\"{}\" fill=\"{}\" stroke=\"{}\" stroke-width=\"{}\"{} "
          "stroke-linejoin=\"round\"/>\n",
          points, line.is_filled ? solid_colour : "none", colour, width, dashes);
    };
    shapes += polyline("#ffffff", style.width + 2, "");
    shapes += polyline(style.colour, style.width, style.dashes);
  }
  return fmt::format(
      "<clipPath id=\"{0}map\"><rect x=\"{1}\" y=\"{2}\" width=\"{3}\" "
      "height=\"{4}\"/></clipPath>\n"
      "<g clip-path=\"url(#{0}map)\">\n{5}{6}</g>\n",
      map.id, layout.left, layout.top, layout.width, layout.height, shapes,
      draw_labels(map, layout));
}

// Eastings along the upper edge and northings along the left one, inside the frame.
std::string draw_coordinates(const Layout& layout) {
  constexpr TextStyle style{.size = 10, .colour = svg_ink, .halo = true};
  constexpr double tick = 6;  // px
  std::string svg;
  for (const double east : ticks_over(layout.view.west, layout.view.east, 4).values) {
    const double x = layout.x(east);
    if (x < layout.left + 60 || x > layout.left + layout.width - 40) continue;
    svg += svg_line(x, layout.top, x, layout.top + tick, svg_ink, 1);
    TextStyle middle = style;
    middle.anchor = Anchor::middle;
    svg += svg_text(x, layout.top + tick + 11, fmt::format("{:.0f} E", east), middle);
  }
  for (const double north : ticks_over(layout.view.south, layout.view.north, 4).values) {
    const double y = layout.y(north);
    if (y < layout.top + 28 || y > layout.top + layout.height - 12) continue;
    svg += svg_line(layout.left, y, layout.left + tick, y, svg_ink, 1);
    svg += svg_text(layout.left + tick + 4, y + 4, fmt::format("{:.0f} N", north), style);
  }
  return svg;
}

// Scale bar and north arrow, below the map on the right.
std::string draw_scale(const MapPicture& map, const Layout& layout, double contour) {
  const double length = round_down(180 / layout.scale);
  const double right = layout.page_width - margin - 44;
  const double left = right - length * layout.scale;
  const double y = layout.top + layout.height + 40;
  std::string svg = fmt::format(
      "<path d=\"M{0:.1f} {2:.1f}v6H{1:.1f}v-6\" fill=\"none\" stroke=\"{3}\" "
      "stroke-width=\"1.6\"/>\n",
      left, right, y - 6, svg_ink);
  svg += svg_text((left + right) / 2, y - 8, fmt::format("{:g} m", length),
                  {.colour = svg_ink, .anchor = Anchor::middle});
  svg += svg_text(right, y + 20, fmt::format("{} {:g} m", map.contours, contour),
                  {.anchor = Anchor::end});
  const double x = layout.page_width - margin - 10;
  svg += fmt::format("<path d=\"M{:.1f} {:.1f}l7 20l-7 -5l-7 5z\" fill=\"{}\"/>\n", x, y - 20,
                     svg_ink);
  return svg + svg_text(x, y + 16, "N",
                        {.size = 13, .colour = svg_ink, .anchor = Anchor::middle, .bold = true});
}

}  // namespace

MapView view_around(const Raster& values, double threshold) {
  const Grid& grid = values.grid;
  int first_column = grid.columns, last_column = -1;
  int first_row = grid.rows, last_row = -1;
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      if (!(values.at(column, row) > threshold)) continue;
      first_column = std::min(first_column, column);
      last_column = std::max(last_column, column);
      first_row = std::min(first_row, row);
      last_row = std::max(last_row, row);
    }
  }
  if (last_column < 0) return {grid.west, grid.south(), grid.east(), grid.north};
  const double longer =
      std::max((last_column - first_column + 1) * grid.dx, (last_row - first_row + 1) * grid.dy);
  const double around = std::max(0.08 * longer, 10 * std::max(grid.dx, grid.dy));
  return {std::max(grid.west, grid.west + first_column * grid.dx - around),
          std::max(grid.south(), grid.north - (last_row + 1) * grid.dy - around),
          std::min(grid.east(), grid.west + (last_column + 1) * grid.dx + around),
          std::min(grid.north, grid.north - first_row * grid.dy + around)};
}

std::string map_svg(const MapPicture& map, const Raster& elevation, const Raster& values) {
  const Layout layout = layout_of(map);
  const double most = greatest(values, map.view);
  const double top = map.top.value_or(most);
  const double contour = contour_step(elevation, map.view);
  std::string svg = svg_begin(layout.page_width, layout.page_height, map.title);
  for (std::size_t k = 0; k < layout.title.size(); ++k)
    svg += svg_text(margin, layout.title_y(k), layout.title[k],
                    {.size = title_size, .colour = svg_ink, .bold = true});
  for (std::size_t k = 0; k < layout.note.size(); ++k)
    svg += svg_text(margin, layout.note_y(k), layout.note[k], {.size = note_size});
  svg += draw_raster({elevation, values, map.threshold, top, contour, map.steps}, layout,
                     map.sharpness);
  if (map.has_coordinates) svg += draw_coordinates(layout);
  svg += draw_lines(map, layout);
  const double bar = layout.top + layout.height + 34;
  if (!map.steps.empty()) {
    svg += svg_step_bar(margin, bar, map.quantity, map.steps);
  } else if (top > 0) {
    svg += svg_colour_bar(margin, bar, map.quantity, top, map.id);
  }
  svg += draw_scale(map, layout, contour);
  return svg + "</svg>\n";
}

}  // namespace sabo
