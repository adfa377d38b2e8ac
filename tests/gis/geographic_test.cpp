#include "io/gis/geographic.hpp"

#include <gtest/gtest.h>

#include "io/gis/crs.hpp"

namespace sabo {
namespace {

TEST(Geographic, TheCentralMeridianOfAZoneIsWhereItShouldBe) {
  OGRSpatialReference utm;
  utm.importFromEPSG(32652);  // zone 52 north: its central meridian is 129 deg, at x = 500 km
  const auto place = geographic(wkt_of(utm), 500000, 0);
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->longitude, 129, 1e-9);
  EXPECT_NEAR(place->latitude, 0, 1e-9);
}

TEST(Geographic, IsUnknownWithoutACoordinateSystem) {
  EXPECT_FALSE(geographic("", 1, 2));
  OGRSpatialReference utm;
  utm.importFromEPSG(32652);
  EXPECT_FALSE(geographic(wkt_of(utm), 1e30, 1e30));
}

}  // namespace
}  // namespace sabo
