#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/output/chart_axis.hpp"
#include "io/output/svg_chart.hpp"

namespace sabo {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::vector<std::string> labels_of(const ChartAxis& axis) {
  std::vector<std::string> labels;
  for (const AxisTick& tick : axis.ticks) labels.push_back(tick.label);
  return labels;
}

std::size_t count_of(const std::string& text, const std::string& piece) {
  std::size_t count = 0;
  for (std::size_t at = text.find(piece); at != text.npos; at = text.find(piece, at + 1)) ++count;
  return count;
}

TEST(LogAxis, HasATickAtEachDecade) {
  const ChartAxis axis = log_axis(0.002, 30, 8);
  EXPECT_THAT(labels_of(axis), ElementsAre("0.001", "0.01", "0.1", "1", "10", "100"));
  EXPECT_EQ(axis.minor.size(), 5u * 8);
  EXPECT_DOUBLE_EQ(axis.share(0.001), 0);
  EXPECT_DOUBLE_EQ(axis.share(0.1), 0.4);
  EXPECT_DOUBLE_EQ(axis.share(100), 1);
}

TEST(LogAxis, LeavesDecadesOutOfAWideRange) {
  const ChartAxis axis = log_axis(1e-9, 1e9, 5);  // 18 decades, every fourth
  EXPECT_THAT(labels_of(axis), ElementsAre("10⁻⁹", "10⁻⁵", "10⁻¹", "10³", "10⁷", "10¹¹"));
  EXPECT_TRUE(axis.minor.empty());
}

TEST(LogAxis, HasTicksInsideANarrowRange) {
  EXPECT_THAT(labels_of(log_axis(2, 7, 5)), ElementsAre("1", "2", "5", "10"));
  EXPECT_THAT(labels_of(log_axis(2e-5, 7e-5, 5)), ElementsAre("10⁻⁵", "2×10⁻⁵", "5×10⁻⁵", "10⁻⁴"));
  // One value on a decade stands in the middle.
  EXPECT_DOUBLE_EQ(log_axis(10, 10, 5).share(10), 0.5);
}

TEST(LogChart, PutsDataWhereTheAxesSay) {
  LineChart chart{.title = "c", .x_title = "x", .y_title = "y"};
  chart.x_log = chart.y_log = true;
  chart.series = {{"s", {0.01, 1, 100}, {1, 10, std::sqrt(10.0)}}};
  // x: four decades on 44 to 696 px; y: one decade on 348 to 78 px, its square root halfway.
  EXPECT_THAT(chart_svg(chart), HasSubstr("d=\"M44.0 348.0L370.0 78.0L696.0 213.0\""));
}

TEST(LogChart, ValuesThatAreNotPositiveLeaveAGap) {
  LineChart chart;
  chart.x_log = chart.y_log = true;
  chart.y_low = -3;  // no place either
  chart.series = {{"s", {0.01, 0.1, 1, 10, 100, -5}, {1, 10, 0, 10, 1, 1}}};
  chart.references = {{0, "level"}};
  const std::string svg = chart_svg(chart);
  EXPECT_THAT(svg, HasSubstr("d=\"M44.0 348.0L207.0 78.0M533.0 78.0L696.0 348.0\""));
  EXPECT_THAT(svg, Not(HasSubstr("level")));
}

TEST(LogChart, NeedsNoDataAndBearsExtremeOnes) {
  LineChart chart;
  chart.x_log = chart.y_log = true;
  for (const std::vector<double>& values :
       {std::vector<double>{}, {0, -1}, {5e-324, 1.7e308}, {1, HUGE_VAL, std::nan("")}}) {
    chart.series = {{"s", values, values}};
    const std::string svg = chart_svg(chart);
    EXPECT_THAT(svg, HasSubstr("</svg>"));
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_THAT(svg, Not(HasSubstr("inf")));
  }
}

TEST(Chart, TheSeventhSeriesHasTheFirstColourDashed) {
  LineChart chart;
  for (int k = 0; k < 8; ++k) chart.series.push_back({std::to_string(k), {0, 1}, {0, k + 1.0}});
  const std::string svg = chart_svg(chart);
  EXPECT_EQ(count_of(svg, "stroke-dasharray=\"8 5\""), 2u * 2);  // line and key of two series
  EXPECT_EQ(count_of(svg, "stroke=\"#0072B2\" stroke-width=\"2\""), 2u);
  EXPECT_EQ(count_of(svg, "stroke=\"#0072B2\" stroke-width=\"2\" stroke-dasharray"), 1u);
}

TEST(Chart, ALegendThatDoesNotFitTakesLinesOfItsOwn) {
  LineChart chart{.title = "c", .y_title = "discharge [m³/s]"};
  chart.series = {{std::string(60, 'a'), {0, 100}, {0, 40}},
                  {std::string(60, 'b'), {0, 1}, {0, 1}}};
  // A name is 0.56 x 13 x 60 = 437 px wide: one on each line of 20 px, and all else 40 px lower.
  const std::string svg = chart_svg(chart);
  EXPECT_THAT(svg, HasSubstr("width=\"720\" height=\"440\""));
  EXPECT_THAT(svg, HasSubstr("x=\"45.0\" y=\"58.0\" font-size=\"13\""));
  EXPECT_THAT(svg, HasSubstr("x=\"45.0\" y=\"78.0\" font-size=\"13\""));
  EXPECT_THAT(svg, HasSubstr("x=\"16.0\" y=\"98.0\" font-size=\"13\""));  // the y title
  EXPECT_THAT(svg, HasSubstr("d=\"M44.0 388.0L696.0 118.0\""));
}

TEST(Chart, AShortLegendStandsBesideTheTitle) {
  LineChart chart{.title = "c", .y_title = "y"};
  chart.series = {{"ab", {0, 100}, {0, 40}}, {"cd", {0, 1}, {0, 1}}};
  const std::string svg = chart_svg(chart);
  EXPECT_THAT(svg, HasSubstr("height=\"400\""));
  // The last name of 0.56 x 13 x 2 = 14.6 px ends at 696.
  EXPECT_THAT(svg, HasSubstr("x=\"681.4\" y=\"58.0\""));
}

}  // namespace
}  // namespace sabo
