#include <cmath>
#include <set>

#include "support/temporary_folder.hpp"
#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/output/colour_scale.hpp"
#include "io/output/index_page.hpp"
#include "io/output/map_picture.hpp"
#include "io/output/png.hpp"
#include "io/output/relief.hpp"
#include "io/output/svg.hpp"
#include "io/output/svg_chart.hpp"
#include "terrain/bilinear.hpp"

namespace sabo {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

LineChart small_chart() {
  LineChart chart{.title = "Discharge <p1>", .x_title = "time [s]", .y_title = "discharge [m³/s]"};
  chart.series = {{"p1", {0, 50, 100}, {0, 40, 20}}};
  return chart;
}

TEST(Chart, PutsDataWhereTheAxesSay) {
  const std::string svg = chart_svg(small_chart());
  // The plot reaches from x = 44 (time 0) to 696 (time 100) and from y = 348 (0) to 78 (40 m3/s).
  EXPECT_THAT(svg, HasSubstr("d=\"M44.0 348.0L370.0 78.0L696.0 213.0\""));
  EXPECT_THAT(svg, HasSubstr(">Discharge &lt;p1&gt;</text>"));
  EXPECT_THAT(svg, HasSubstr(">discharge [m³/s]</text>"));
}

TEST(Chart, LeavesAGapForAMissingValue) {
  LineChart chart = small_chart();
  chart.series = {{"p1", {0, 25, 50, 75, 100}, {0, 40, std::nan(""), 40, 0}}};
  const std::string svg = chart_svg(chart);
  EXPECT_THAT(svg, HasSubstr("d=\"M44.0 348.0L207.0 78.0M533.0 78.0L696.0 348.0\""));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

TEST(Chart, MarksPlacesOnTheAxis) {
  LineChart chart = small_chart();
  // 25 of 100 s: a quarter of 44 to 696 px. The wall reaches from 0 to 20 of 40 m3/s.
  chart.marks = {{25, "<dam>", 0, 20}, {500, "outside"}};
  const std::string svg = chart_svg(chart);
  EXPECT_THAT(svg, HasSubstr("x1=\"207.0\" y1=\"78.0\" x2=\"207.0\" y2=\"348.0\""));
  EXPECT_THAT(svg, HasSubstr("x1=\"207.0\" y1=\"348.0\" x2=\"207.0\" y2=\"213.0\""));
  EXPECT_THAT(svg, HasSubstr("&lt;dam&gt;"));
  EXPECT_THAT(svg, Not(HasSubstr("outside")));
}

TEST(Chart, LinesMayDifferWithoutColours) {
  LineChart chart = small_chart();
  chart.series.push_back(chart.series[0]);
  EXPECT_THAT(chart_svg(chart), Not(HasSubstr("stroke-dasharray")));
  chart.has_dashes = true;
  EXPECT_THAT(chart_svg(chart), HasSubstr("stroke-dasharray=\"8 5\""));
  std::set<std::pair<std::string, std::string>> styles;
  for (std::size_t k = 0; k < 36; ++k)
    styles.insert({chart_style(chart, k).colour, chart_style(chart, k).dashes});
  EXPECT_EQ(styles.size(), 36u);
}

TEST(Chart, WideCharactersTakeMoreRoom) {
  EXPECT_DOUBLE_EQ(text_width("ab", 10), 11.2);
  EXPECT_DOUBLE_EQ(text_width("堰堤", 10), 20);
  EXPECT_DOUBLE_EQ(text_width("−é", 10), 11.2);
}

TEST(Chart, NeedsNoData) {
  LineChart chart{.title = "Nothing"};
  EXPECT_THAT(chart_svg(chart), HasSubstr("</svg>"));
  chart.series = {{"flat", {5}, {3}}, {"empty", {}, {}}};
  chart.references = {{3, "level"}};
  EXPECT_THAT(chart_svg(chart), Not(HasSubstr("nan")));
}

TEST(FlowColour, GoesFromYellowToViolet) {
  EXPECT_EQ(hex(flow_colour(0)), "#fde725");
  EXPECT_EQ(hex(flow_colour(0.5)), "#21918c");
  EXPECT_EQ(hex(flow_colour(1)), "#440154");
  EXPECT_EQ(flow_colour(7), flow_colour(1));
  EXPECT_EQ(flow_colour(std::nan("")), flow_colour(0));
}

TEST(Png, ComesBackAsDrawn) {
  const TemporaryFolder folder;
  const Image image{3, 2, {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {1, 2, 3}, {4, 5, 6}, {7, 8, 9}}};
  const auto file = folder.write("a.png", png_of(image));
  GDALDatasetUniquePtr data(GDALDataset::Open(file.c_str(), GDAL_OF_RASTER));
  ASSERT_TRUE(data);
  std::vector<Colour> pixels(6);
  ASSERT_EQ(data->RasterIO(GF_Read, 0, 0, 3, 2, pixels.data(), 3, 2, GDT_Byte, 3, nullptr, 3, 9, 1,
                           nullptr),
            CE_None);
  EXPECT_EQ(pixels, image.pixels);
}

TEST(Relief, InterpolatesBetweenCellCentres) {
  Raster raster(Grid{.columns = 2, .rows = 1, .north = 1});
  raster.values = {0, 10};
  EXPECT_DOUBLE_EQ(bilinear(raster, 1, 0.5, 0), 5);
  EXPECT_DOUBLE_EQ(bilinear(raster, 0.1, 0.5, 0), 0);
  EXPECT_TRUE(std::isnan(bilinear(raster, 2.1, 0.5, 0)));
  raster.values[1] = Raster::no_data;
  EXPECT_DOUBLE_EQ(bilinear(raster, 1, 0.5, 4), 2);
}

TEST(Relief, DrawsValuesAboveTheThresholdOnly) {
  const Raster ground(Grid{.columns = 30, .rows = 10, .north = 10}, 5);
  Raster depth(ground.grid, 0.01);
  for (int row = 0; row < 10; ++row) depth.at(25, row) = 2;
  const Image image = draw_relief({ground, depth, 0.05, 2, 10}, {0, 0, 30, 10}, 30, 10);
  const Colour flat = image.pixels[5 * 30 + 5];
  EXPECT_EQ(flat[0], flat[1]);  // grey ground
  EXPECT_EQ(flat[0], flat[2]);
  const Colour deep = image.pixels[5 * 30 + 25];
  EXPECT_GT(deep[2], deep[1]);  // violet
}

TEST(StepColour, HasOneForEachClass) {
  const std::vector<ColourStep> steps{{4, {1, 0, 0}}, {5, {2, 0, 0}}, {0, {3, 0, 0}}};
  EXPECT_EQ(step_colour(steps, -1)[0], 1);
  EXPECT_EQ(step_colour(steps, 3.999)[0], 1);
  EXPECT_EQ(step_colour(steps, 4)[0], 2);
  EXPECT_EQ(step_colour(steps, 5)[0], 3);
  EXPECT_EQ(step_colour(steps, 1e9)[0], 3);
}

TEST(Relief, MixesNoClassesBetweenCells) {
  const Raster ground(Grid{.columns = 2, .rows = 1, .north = 1}, 5);
  Raster layers(ground.grid);
  layers.values = {1, 9};
  // Between the two lies the class of 4 to 6, whose green shows nowhere.
  const std::vector<ColourStep> steps{{4, {255, 0, 0}}, {6, {0, 255, 0}}, {0, {0, 0, 255}}};
  const Image image = draw_relief({ground, layers, 0, 9, 10, steps}, {0, 0, 2, 1}, 40, 20);
  for (int column = 0; column < 40; ++column) {
    const Colour& colour = image.pixels[10 * 40 + column];
    EXPECT_GT(colour[column < 20 ? 0 : 2], colour[1]) << column;
  }
  layers.values[1] = Raster::no_data;
  const Colour bare =
      draw_relief({ground, layers, 0, 9, 10, steps}, {0, 0, 2, 1}, 40, 20).pixels[395];
  EXPECT_EQ(bare[0], bare[2]) << "no data is bare ground";
}

TEST(Map, ShowsTheClassesOfASteppedScale) {
  const Raster ground(Grid{.columns = 30, .rows = 10, .north = 10}, 5);
  MapPicture map{"Resolution", "", "particles"};
  map.view = {0, 0, 30, 10};
  map.steps = {{4, {179, 88, 6}, "under 4"}, {0, {84, 39, 136}, "4 or more"}};
  const std::string svg = map_svg(map, ground, Raster(ground.grid, Raster::no_data));
  for (const char* part : {">under 4</text>", ">4 or more</text>", "#b35806", "#542788"})
    EXPECT_THAT(svg, HasSubstr(part));
  EXPECT_THAT(svg, Not(HasSubstr("linearGradient")));
}

TEST(ViewAround, HoldsTheFlowWithAMarginInsideTheGrid) {
  Raster depth(Grid{.columns = 1000, .rows = 100, .north = 100}, 0);
  for (int column = 5; column < 505; ++column) depth.at(column, 50) = 1;
  const MapView view = view_around(depth, 0.05);
  EXPECT_DOUBLE_EQ(view.west, 0);
  EXPECT_DOUBLE_EQ(view.east, 505 + 0.08 * 500);
  EXPECT_DOUBLE_EQ(view.north, 50 + 40);
  EXPECT_DOUBLE_EQ(view.south, 49 - 40);
  EXPECT_DOUBLE_EQ(view_around(Raster(depth.grid, 0), 0.05).east, 1000);
}

TEST(Map, AValleyIsAWidePicture) {
  const Raster ground(Grid{.columns = 120, .rows = 15, .north = 150, .dx = 10, .dy = 10}, 5);
  Raster depth(ground.grid, Raster::no_data);
  depth.at(60, 7) = 3;
  MapPicture map{.title = "Deposit & dam", .quantity = "depth [m]", .threshold = 0.05};
  map.view = {0, 0, 1200, 150};
  map.lines = {{MapLine::Kind::dam, "<dam>", {{{600, 0, 0}, {600, 150, 0}}, false}}};
  const std::string svg = map_svg(map, ground, depth);
  EXPECT_THAT(svg, StartsWith("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"1140\""));
  // 1100 px for 1200 m: the picture is 138 px high and the dam in its middle.
  EXPECT_THAT(svg, HasSubstr("width=\"1100\" height=\"138\" preserveAspectRatio"));
  EXPECT_THAT(svg, HasSubstr("points=\"570.0,185.5 570.0,48.0 \""));
  EXPECT_THAT(svg, HasSubstr("&lt;dam&gt;"));
  EXPECT_THAT(svg, HasSubstr("data:image/png;base64,iVBOR"));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

/// Baseline of a label.
double y_of(const std::string& svg, const std::string& label) {
  const std::size_t end = svg.find(">" + label + "</text>");
  if (end == svg.npos) return -1;
  const std::size_t begin = svg.rfind(" y=\"", end);
  return std::stod(svg.substr(begin + 4, 10));
}

TEST(Map, LabelsOfOnePlaceStandBelowEachOther) {
  const Raster ground(Grid{.columns = 30, .rows = 10, .north = 10}, 5);
  MapPicture map{.title = "t", .quantity = "depth [m]", .view = {0, 0, 30, 10}};
  const std::vector<Vec3d> ring{{5, 2, 0}, {9, 2, 0}, {9, 8, 0}, {5, 8, 0}, {5, 2, 0}};
  map.lines = {{MapLine::Kind::zone, "first", {ring, false}},
               {MapLine::Kind::zone, "second", {ring, false}},
               {MapLine::Kind::zone, "outside", {{{40, 2, 0}, {50, 2, 0}, {50, 8, 0}}, false}}};
  const std::string svg = map_svg(map, ground, Raster(ground.grid, 0));
  EXPECT_NEAR(y_of(svg, "second"), y_of(svg, "first") + 15, 0.01);
  EXPECT_EQ(y_of(svg, "outside"), -1);
}

TEST(Map, HasCoordinatesAndTextsOfItsOwn) {
  const Raster ground(Grid{.columns = 30, .rows = 10, .west = 500000, .north = 4000010}, 5);
  MapPicture map{.title = "t", .quantity = "depth [m]"};
  map.view = {500000, 4000000, 500030, 4000010};
  map.contours = "Höhenlinien alle";
  map.id = "m7-";
  map.has_coordinates = true;
  const std::string svg = map_svg(map, ground, Raster(ground.grid, 1));
  for (const char* part : {">500010 E</text>", ">4000004 N</text>", "Höhenlinien alle 1 m",
                           "id=\"m7-map\"", "url(#m7-map)", "id=\"m7-scale\"", "url(#m7-scale)"})
    EXPECT_THAT(svg, HasSubstr(part));
}

TEST(Map, AStripIsStillAPicture) {
  const Raster ground(Grid{.columns = 2000, .rows = 2, .north = 2}, 5);
  MapPicture map{.title = "Strip", .quantity = "depth [m]", .view = {0, 0, 2000, 2}};
  map.lines = {{MapLine::Kind::section, "p1", {{{1000, 0, 0}, {1000, 2, 0}}, false}}};
  // 2000 m on 1100 px, 50 m high at least.
  EXPECT_THAT(map_svg(map, ground, Raster(ground.grid, 0)),
              HasSubstr("width=\"1100\" height=\"28\" preserveAspectRatio"));
}

TEST(IndexPage, EscapesEveryText) {
  const std::string bad = "<b>&";
  IndexPage page{bad, bad, bad, {{bad, bad}}, {{bad, {bad}, {{bad}}}}, {}, {}};
  page.warning = page.remarks = bad;
  page.pictures = {{{"maps/<b>.svg"}, bad, true}};
  page.files = {{"a b.csv", bad}};
  page.details = {{"details " + bad, {bad}, {{bad}}}};
  const std::string html = index_html(page);
  EXPECT_THAT(html, StartsWith("<!doctype html>"));
  EXPECT_THAT(html, Not(HasSubstr("<b>")));
  EXPECT_THAT(html, HasSubstr("<title>&lt;b&gt;&amp;</title>"));
  EXPECT_THAT(html, HasSubstr("src=\"maps/%3Cb%3E.svg\""));
  EXPECT_THAT(html, HasSubstr("href=\"a%20b.csv\""));
  EXPECT_LT(html.find("<h2>Pictures"), html.find("<h2>details ")) << "details stand below";
}

}  // namespace
}  // namespace sabo
