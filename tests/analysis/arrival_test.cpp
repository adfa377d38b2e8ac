#include "analysis/arrival.hpp"

#include <gtest/gtest.h>

namespace sabo {
namespace {

/// Flow from the west at 2 m/s in a channel of y from 4 to 6, on cells of 1 m, as far as x = 15.
Raster channel() {
  Raster arrival(Grid{20, 10, 0, 10, 1, 1}, Raster::no_data);
  for (int column = 0; column < 15; ++column)
    for (int row = 4; row < 6; ++row) arrival.at(column, row) = arrival.grid.x_of(column) / 2;
  return arrival;
}

TEST(FirstArrival, IsTheEarliestAlongTheLine) {
  // In the channel the line goes from x = 9 to 9.5, the cell whose centre is at 9.5 m.
  EXPECT_EQ(first_arrival(channel(), {{{7, 0, 0}, {12, 10, 0}}}, 0), 9.5 / 2);
  EXPECT_EQ(first_arrival(channel(), {{{9.2, 0, 0}, {9.2, 10, 0}}}, 0), 9.5 / 2);
}

TEST(FirstArrival, TakesItsWidthOnBothSides) {
  // 3 m to either side of x = 9.2: the cell of 6.2 m.
  const Polyline north{{{9.2, 0, 0}, {9.2, 10, 0}}}, south{{{9.2, 10, 0}, {9.2, 0, 0}}};
  EXPECT_EQ(first_arrival(channel(), north, 3), 6.5 / 2);
  EXPECT_EQ(first_arrival(channel(), south, 3), 6.5 / 2);
}

TEST(FirstArrival, IsNoneWhereTheFlowNeverCame) {
  EXPECT_FALSE(first_arrival(channel(), {{{17, 0, 0}, {17, 10, 0}}}, 1));
  EXPECT_FALSE(first_arrival(channel(), {{{5, 20, 0}, {5, 30, 0}}}, 1)) << "outside the map";
}

}  // namespace
}  // namespace sabo
