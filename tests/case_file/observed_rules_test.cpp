#include "case_file/support.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/case_file/write_case.hpp"

namespace sabo {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string outline = "outline = [[0, 0], [9, 0], [9, 9]]\n";

TEST(ObservedRules, AFootprintIsGivenInOneWay) {
  EXPECT_THAT(messages(smallest_case + "[observed]\n" + outline + "within = \"release.gpkg\"\n"),
              IsEmpty());
  EXPECT_THAT(messages(smallest_case + "[observed]\n" + outline + "depth_raster = \"dem.tif\"\n"),
              ElementsAre("case.toml:11 observed: has a depth_raster and an outline; give one of "
                          "the two"));
  EXPECT_THAT(messages(smallest_case + "[observed]\nwithin = \"release.gpkg\"\n"),
              ElementsAre(HasSubstr("observed.within: has nothing to compare in it")));
  EXPECT_THAT(messages(smallest_case + "[observed]\noutline = [[0, 0], [9, 0]]\n"),
              ElementsAre(HasSubstr("observed.outline: has fewer than three points")));
}

TEST(ObservedRules, ArrivalsHaveAPlaceATimeAndANameOfTheirOwn) {
  const std::string arrival = "[[observed.arrival]]\nplace = [1, 2]\ntime = 3\n";
  EXPECT_THAT(messages(smallest_case + arrival + arrival), IsEmpty()) << "nameless ones get names";
  EXPECT_THAT(messages(smallest_case + "[[observed.arrival]]\nname = \"a\"\n"),
              ElementsAre(HasSubstr("observed.arrival[1].place: is missing"),
                          HasSubstr("observed.arrival[1].time: is missing")));
  const std::string named = arrival + "name = \"bridge\"\n";
  EXPECT_THAT(messages(smallest_case + named + named),
              ElementsAre(HasSubstr("\"bridge\" is the name of observed.arrival[1] too")));
}

TEST(ObservedRules, AreWrittenBack) {
  Faults faults;
  const Case c = read_case_text(
      smallest_case + "[observed]\nwet_depth = 0.25\nmap = \"peak_depth\"\n" + outline +
          "[[observed.arrival]]\nname = \"bridge\"\nplace = [1.5, 2]\ntime = 3\n",
      folder_with_files(), faults);
  ASSERT_TRUE(faults.empty());
  const Case back = read_case_text(write_case(c), "/", faults);
  ASSERT_TRUE(faults.empty()) << to_string(faults.list().front());
  EXPECT_EQ(back.observed.wet_depth, 0.25);
  EXPECT_EQ(back.observed.map, ComparedMap::peak_depth);
  ASSERT_EQ(back.observed.arrivals.size(), 1u);
  EXPECT_EQ(back.observed.arrivals[0].place[0], 1.5);
  EXPECT_EQ(back.observed.outline.coordinates.size(), 3u);
}

}  // namespace
}  // namespace sabo
