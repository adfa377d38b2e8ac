#include <cmath>

#include "gis/made_raster.hpp"
#include "support/fault_of.hpp"
#include "support/temporary_folder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/gis/read_raster.hpp"

namespace sabo {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsNan;

class ReadThickness : public testing::Test {
 protected:
  Raster read(const MadeRaster& made, const std::string& dem_crs, bool assume_metres = false) {
    made.write(folder_ / "h.tif");
    return read_thickness(folder_ / "h.tif", {"release.thickness_raster", dem_crs, assume_metres});
  }
  Fault fault(const MadeRaster& made, const std::string& dem_crs) {
    return fault_of([&] { read(made, dem_crs); });
  }
  TemporaryFolder folder_;
  const std::string utm54_ = wkt_of_code("EPSG:32654");
};

TEST_F(ReadThickness, ReadsARasterInTheCrsOfTheDem) {
  const Raster raster = read({.values = {0, 0.5, 2, -9999, 1, 0}, .nodata = -9999}, utm54_);
  EXPECT_THAT(raster.values, ElementsAre(0, 0.5, 2, IsNan(), 1, 0));
  EXPECT_EQ(raster.grid.dx, 10);
}

TEST_F(ReadThickness, ComparesPlacesOnTheMapOnly) {
  // The DEM carries a vertical datum (JGD2011 / UTM 54N + heights), the raster does not.
  EXPECT_NO_THROW(read({.crs = "EPSG:6691"}, wkt_of_code("EPSG:6691+6695")));
}

TEST_F(ReadThickness, RefusesAnotherCrsAndNamesBoth) {
  const Fault wrong = fault({.crs = "EPSG:27700"}, wkt_of_code("EPSG:5266"));
  EXPECT_EQ(wrong.place, "release.thickness_raster");
  EXPECT_THAT(wrong.problem, HasSubstr("EPSG:27700 (OSGB36 / British National Grid)"));
  EXPECT_THAT(wrong.problem, HasSubstr("EPSG:5266"));
}

TEST_F(ReadThickness, NeedsACrsWhenTheDemHasOne) {
  EXPECT_THAT(fault({.crs = ""}, utm54_).problem, HasSubstr("no coordinate system"));
  EXPECT_NO_THROW(read({.crs = ""}, utm54_, true));
  EXPECT_NO_THROW(read({.crs = ""}, ""));
  EXPECT_NO_THROW(read({.crs = "EPSG:32654"}, ""));
  EXPECT_THAT(fault({.crs = "EPSG:4326"}, "").problem, HasSubstr("EPSG:4326"));
}

TEST_F(ReadThickness, RefusesNegativeAndEmptyThickness) {
  EXPECT_THAT(fault({.values = {0, 1, -0.5, -9999, 0, 0}}, utm54_).problem,
              HasSubstr("2 cells of negative thickness, e.g. -0.5 m"));
  EXPECT_THAT(fault({.values = {0, 0, 0, 0, 0, 0}}, utm54_).problem,
              HasSubstr("no cell of positive thickness"));
}

}  // namespace
}  // namespace sabo
