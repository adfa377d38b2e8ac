#include "io/gis/fg_gml.hpp"

#include <cmath>

#include "gis/made_fg_gml.hpp"
#include "support/fault_of.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sabo {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsNan;

FgGmlTile parse(const MadeFgGml& made) { return parse_fg_gml(made.text(), "t.xml"); }

std::string problem(const std::string& text) {
  const Fault fault = fault_of([&] { parse_fg_gml(text, "t.xml"); });
  EXPECT_EQ(fault.place, "terrain.dem");
  EXPECT_THAT(fault.problem, HasSubstr("t.xml"));
  EXPECT_NE(fault.remedy, "");
  return fault.problem;
}

std::string problem(const MadeFgGml& made) { return problem(made.text()); }

std::string without(std::string text, const std::string& part) {
  return text.erase(text.find(part), part.size());
}

TEST(FgGml, KeepsMeasuredWaterAndEveryOtherKindWithAnElevation) {
  EXPECT_THAT(parse({}).raster.values, ElementsAre(1.25, 2, 3, IsNan(), -5.5, 6));
}

TEST(FgGml, CornersAreOuterEdgesWithTheLatitudeFirst) {
  const FgGmlTile tile = parse({});
  const Grid& grid = tile.raster.grid;
  EXPECT_EQ(grid.columns, 3);
  EXPECT_EQ(grid.rows, 2);
  constexpr double digits = 1e-9;  // of the corners
  EXPECT_NEAR(grid.west, 141, digits);
  EXPECT_NEAR(grid.north, 45, digits);
  EXPECT_NEAR(grid.dx, 0.2 / 3600, digits);
  EXPECT_NEAR(grid.dy, 0.2 / 3600, digits);
  EXPECT_EQ(tile.date, "2016-10-01");
}

TEST(FgGml, ValuesBeginAtTheStartPointAndMayEndEarly) {
  const FgGmlTile tile =
      parse({.tuples = "地表面,5\n地表面,6\n", .start = "<gml:startPoint>2 0</gml:startPoint>"});
  EXPECT_THAT(tile.raster.values, ElementsAre(IsNan(), IsNan(), 5, 6, IsNan(), IsNan()));
  const FgGmlTile none = parse({.tuples = ""});
  EXPECT_THAT(none.raster.values, testing::Each(IsNan()));
}

TEST(FgGml, StartPointAndGridCountFromTheLowCorner) {
  const FgGmlTile tile = parse({.tuples = "地表面,6\n",
                                .start = "<gml:startPoint>12 21</gml:startPoint>",
                                .low = "10 20",
                                .high = "12 21"});
  EXPECT_EQ(tile.raster.at(2, 1), 6);
  EXPECT_TRUE(std::isnan(tile.raster.at(0, 0)));
  const FgGmlTile first =
      parse({.tuples = "地表面,6\n", .start = "", .low = "10 20", .high = "12 21"});
  EXPECT_EQ(first.raster.at(0, 0), 6);
}

TEST(FgGml, ReadsTheThreeDatums) {
  EXPECT_EQ(parse({.srs = "fguuid:jgd2000.bl"}).datum, JapaneseDatum::jgd2000);
  EXPECT_EQ(parse({.srs = "fguuid:jgd2011.bl"}).datum, JapaneseDatum::jgd2011);
  EXPECT_EQ(parse({.srs = "fguuid:jgd2024.bl"}).datum, JapaneseDatum::jgd2024);
  EXPECT_THAT(problem(MadeFgGml{.srs = "fguuid:tokyo.bl"}), HasSubstr("\"fguuid:tokyo.bl\""));
}

TEST(FgGml, NoDataIsKnownByItsKindToo) {
  EXPECT_THAT(parse({.tuples = "データなし,0\n地表面,0\n"}).raster.at(0, 0), IsNan());
  EXPECT_EQ(parse({.tuples = "データなし,0\n地表面,0\n"}).raster.at(1, 0), 0);
}

TEST(FgGml, ReadsShiftJisWithWindowsLineEnds) {
  // 地表面 and データなし in Shift_JIS; the second byte of the first 表 would be a backslash.
  const std::string ground = "\x92\x6e\x95\x5c\x96\xca";
  const std::string none = "\x83\x66\x81\x5b\x83\x5e\x82\xc8\x82\xb5";
  std::string text =
      MadeFgGml{.tuples = ground + ",7.5\r\n" + none + ",-9999.\r\n" + none + ",0\r\n"}.text();
  text.replace(text.find("UTF-8"), 5, "Shift_JIS");
  EXPECT_THAT(parse_fg_gml(text, "t.xml").raster.values,
              ElementsAre(7.5, IsNan(), IsNan(), IsNan(), IsNan(), IsNan()));
}

TEST(FgGml, RefusesWhatIsNoTile) {
  EXPECT_THAT(problem(""), HasSubstr("no complete XML"));
  EXPECT_THAT(problem("elevations"), HasSubstr("no elevation model of the GSI base map"));
  const std::string whole = MadeFgGml{}.text();
  EXPECT_THAT(problem(whole.substr(0, whole.size() - 20)), HasSubstr("no complete XML"));
  EXPECT_THAT(problem("<html><body/></html>"), HasSubstr("no elevation model of the GSI base map"));
  EXPECT_THAT(problem("<Dataset><BldA/></Dataset>"), HasSubstr("no elevation model"));
  EXPECT_THAT(problem("<Dataset><DEM/><DEM/></Dataset>"), HasSubstr("more than one DEM"));
}

TEST(FgGml, NamesTheMissingElement) {
  const std::string text = MadeFgGml{}.text();
  EXPECT_THAT(problem(without(text, "<gml:low>0 0</gml:low>")), HasSubstr("has no gml:low"));
  EXPECT_THAT(problem(without(text, "<gml:high>2 1</gml:high>")), HasSubstr("has no gml:high"));
  EXPECT_THAT(problem(without(text, "srsName=\"fguuid:jgd2011.bl\"")), HasSubstr("has no srsName"));
  EXPECT_THAT(problem(without(text, " order=\"+x-y\"")), HasSubstr("has no order"));
  std::string corner = text;
  corner.replace(corner.find("<gml:lowerCorner>"), 17, "<gml:x>");
  corner.replace(corner.find("</gml:lowerCorner>"), 18, "</gml:x>");
  EXPECT_THAT(problem(corner), HasSubstr("has no gml:lowerCorner"));
  std::string list = text;
  list.replace(list.find("<gml:tupleList>"), 15, "<gml:x>");
  list.replace(list.find("</gml:tupleList>"), 16, "</gml:x>");
  EXPECT_THAT(problem(list), HasSubstr("has no gml:tupleList"));
  // A comment would part the list in two.
  EXPECT_THAT(problem(MadeFgGml{.tuples = "a,1\n<!-- -->\na,2\n"}), HasSubstr("no gml:tupleList"));
}

TEST(FgGml, RefusesAGridThatCannotBe) {
  EXPECT_THAT(problem(MadeFgGml{.high = "2"}), HasSubstr("\"2\" as gml:high"));
  EXPECT_THAT(problem(MadeFgGml{.high = "2 1 0"}), HasSubstr("not two numbers"));
  EXPECT_THAT(problem(MadeFgGml{.high = "2 x"}), HasSubstr("not two numbers"));
  EXPECT_THAT(problem(MadeFgGml{.high = "2 -1"}), HasSubstr("3 x 0 cells"));
  EXPECT_THAT(problem(MadeFgGml{.high = "9999 999"}), HasSubstr("10000 x 1000 cells"));
  EXPECT_THAT(problem(MadeFgGml{.low = "-2147483648 0", .high = "2147483647 2147483647"}),
              HasSubstr("4294967296 x 2147483648 cells"));
  EXPECT_THAT(problem(MadeFgGml{.rows = -2}), HasSubstr("not south-west of the upper one"));
  EXPECT_THAT(problem(MadeFgGml{.columns = 0}), HasSubstr("not south-west of the upper one"));
  EXPECT_THAT(problem(MadeFgGml{.west_cells = 800000}), HasSubstr("no latitude and longitude"));
  EXPECT_THAT(problem(MadeFgGml{.seconds = 0.0001}), HasSubstr("has cells of"));
  EXPECT_THAT(problem(MadeFgGml{.start = "<gml:startPoint>3 0</gml:startPoint>"}),
              HasSubstr("start point 3 0, beside its 3 x 2 cells"));
  EXPECT_THAT(problem(MadeFgGml{.start = "<gml:startPoint>0 -1</gml:startPoint>"}),
              HasSubstr("start point 0 -1"));
  EXPECT_THAT(problem(MadeFgGml{.order = "+x+y"}), HasSubstr("order \"+x+y\""));
}

TEST(FgGml, RefusesValuesThatAreNoElevations) {
  EXPECT_THAT(problem(MadeFgGml{.tuples = "a,1\na,2\na,3\na,4\na,5\na,6\na,7\n"}),
              HasSubstr("more values than the 6 cells"));
  EXPECT_THAT(
      problem(MadeFgGml{.tuples = "a,1\na,2\n", .start = "<gml:startPoint>2 1</gml:startPoint>"}),
      HasSubstr("more values than the 1 cells from its start point on"));
  for (const std::string bad : {"b", "b,", "b,1m", "b,nan", "b,inf", "b,1e999", "b,1,2", "3.5"}) {
    EXPECT_THAT(problem(MadeFgGml{.tuples = "a,1\n" + bad + "\na,3\n"}),
                HasSubstr("\"" + bad + "\" as value 2"));
  }
}

}  // namespace
}  // namespace sabo
