#include "analysis/run_out.hpp"

#include <gtest/gtest.h>

namespace sabo {
namespace {

const Grid grid{10, 4, 100, 208, 2, 2};  // x from 100 to 120, y from 200 to 208

TEST(RunOut, IsTheFarthestCellAlongThePath) {
  // Down the valley from east to west; centres of columns 2 and 5 are at 105 and 111.
  const Polyline path{{{119, 204, 0}, {101, 204, 0}}};
  const std::vector<std::size_t> cells{grid.index(5, 1), grid.index(2, 1), grid.index(2, 3)};
  const auto place = place_of(grid, cells, path);
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->station, 14, 1e-9);
  EXPECT_NEAR(place->centroid_x, 107, 1e-9);
  EXPECT_NEAR(place->centroid_y, (205 + 205 + 201) / 3.0, 1e-9);
  EXPECT_FALSE(place_of(grid, {}, path));
}

TEST(RunOut, ArrivalMayBeThatOfACellBeside) {
  Raster arrival(grid, Raster::no_data);
  arrival.at(3, 2) = 12;
  arrival.at(4, 2) = 9;
  EXPECT_EQ(arrival_at(arrival, grid.x_of(3), grid.y_of(2)), 12);
  EXPECT_EQ(arrival_at(arrival, grid.x_of(3), grid.y_of(1)), 9) << "the earlier of two beside it";
  EXPECT_FALSE(arrival_at(arrival, grid.x_of(7), grid.y_of(2)));
  EXPECT_FALSE(arrival_at(arrival, 0, 0));
}

}  // namespace
}  // namespace sabo
