#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace sabo {

struct ChartSeries {
  std::string name = {};
  std::vector<double> x = {};
  std::vector<double> y = {};  ///< a value that is not finite leaves a gap, and one that is not
                               ///< positive does on a logarithmic axis
  bool has_markers = false;    ///< a dot at each point, for measured values
  bool has_line = true;
};

/// A horizontal line at a value worth comparing with.
struct ChartReference {
  double y = 0;
  std::string label;
};

/// A place on the x axis, e.g. a check dam on a long profile; with a wall from `low` to `high`.
struct ChartMark {
  double x = 0;
  std::string label = {};
  std::optional<double> low = {}, high = {};
};

/// A line chart. Titles of the axes carry their units, e.g. "time [s]".
struct LineChart {
  std::string title = {};
  std::string x_title = {};
  std::string y_title = {};
  std::vector<ChartSeries> series = {};
  std::vector<ChartReference> references = {};
  std::vector<ChartMark> marks = {};
  std::optional<double> x_low = {}, x_high = {};  ///< else from the data
  std::optional<double> y_low = {}, y_high = {};  ///< else from the data and, if linear, 0
  int width = 720;
  int height = 400;    ///< grows by the lines of a legend that does not fit beside the y title
  bool x_log = false;  ///< logarithmic axes; their limits are positive, others count as not given
  bool y_log = false;
  bool has_zero = true;     ///< a linear y axis reaches to 0
  bool has_dashes = false;  ///< lines differ by their dashes too, for paper without colours
  std::string id = {};      ///< told apart from other charts in one page by it
};

/// How a series is drawn; `dashes` are lengths of strokes and gaps, px, "" for a full line.
struct ChartStyle {
  const char* colour;
  const char* dashes;
};

/// Of the series with this number, from 0.
ChartStyle chart_style(const LineChart& chart, std::size_t series);

/// The chart as an SVG file. Colours: six of Okabe and Ito's, told apart with any colour vision;
/// the next six series have them again with dashed lines, and so on in turn.
std::string chart_svg(const LineChart& chart);

}  // namespace sabo
