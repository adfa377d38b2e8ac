#include "analysis/resolution.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace sabo {
namespace {

TEST(ResolutionGuard, counts_the_wet_cells_only) {
  Raster depth({3, 2, 0, 4, 2, 2}, 0);  // cells of 4 m2
  depth.values = {0.04, Raster::no_data, 1, 3, 2, 8};
  const ResolutionGuard guard = resolution_guard(depth, 0.5);  // 2, 6, 4, 16 layers
  EXPECT_EQ(guard.wet_area, 16);
  EXPECT_EQ(guard.median_layers, 5);
  EXPECT_EQ(guard.thin_share, 0.25);
  EXPECT_EQ(guard.barely_share, 0.25);
}

TEST(ResolutionGuard, of_an_odd_number_of_cells_and_of_none) {
  Raster depth({3, 1, 0, 1, 1, 1}, 0);
  depth.values = {9, 1, 2};
  EXPECT_EQ(resolution_guard(depth, 1).median_layers, 2);
  depth.values = {0, 0, Raster::no_data};
  EXPECT_EQ(resolution_guard(depth, 1).wet_area, 0);
}

// Under 4 is too coarse, from 4 to under 5 barely enough.
TEST(ResolutionGuard, tells_three_grades_apart) {
  Raster depth({1, 1, 0, 1, 1, 1}, 0);
  const auto guard = [&](double layers) {
    depth.values = {layers * 0.25};
    return resolution_guard(depth, 0.25);
  };
  EXPECT_TRUE(guard(3.99).is_too_coarse());
  EXPECT_FALSE(guard(3.99).is_barely_enough());
  EXPECT_TRUE(guard(4).is_barely_enough());
  EXPECT_FALSE(guard(4).is_too_coarse());
  EXPECT_TRUE(guard(4.99).is_barely_enough());
  EXPECT_FALSE(guard(5).is_barely_enough());
}

TEST(LayersMap, is_depth_over_spacing_where_it_was_wet) {
  Raster depth({4, 1, 0, 1, 1, 1}, 0);
  depth.values = {3, 0.06, 0.04, Raster::no_data};
  const Raster layers = layers_map(depth, 0.5);
  EXPECT_EQ(layers.values[0], 6);
  EXPECT_EQ(layers.values[1], 0.12);
  EXPECT_TRUE(std::isnan(layers.values[2])) << "a film is no flow";
  EXPECT_TRUE(std::isnan(layers.values[3]));
}

}  // namespace
}  // namespace sabo
