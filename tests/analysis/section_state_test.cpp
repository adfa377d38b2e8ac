#include "analysis/section_state.hpp"

#include <gtest/gtest.h>

namespace sabo {
namespace {

constexpr double slab_spacing = 0.5, density = 1000;

/// A level channel from west to east, 4 m wide, filled 1 m deep with lattice particles that move
/// along x the faster the higher they are: 1 m/s in the lower half, 3 m/s in the upper one.
Particles channel_flow() {
  Particles flow;
  for (double x = 0.25; x < 20; x += slab_spacing)
    for (double y = 0.25; y < 4; y += slab_spacing)
      for (const double z : {0.25, 0.75}) {
        flow.resize(flow.size() + 1);
        flow.position.back() = {x, y, z};
        flow.velocity.back() = {z < 0.5 ? 1.0 : 3.0, 0.2, 0};
        flow.mass.back() = density * slab_spacing * slab_spacing * slab_spacing;
      }
  return flow;
}

Surface level_ground() {
  Raster ground(Grid{24, 8, -2, 6, 1, 1});
  ground.values.assign(ground.grid.size(), 0.0);
  return Surface(ground);
}

TEST(SectionState, IsThatOfTheChannel) {
  // From north to south: the flow to the east crosses from right to left, looking along it.
  const SectionSlab slab(Polyline{{{10, 4, 0}, {10, 0, 0}}, false}, slab_spacing, density);
  const SectionState state = slab.measure(level_ground(), channel_flow());
  EXPECT_NEAR(state.area, 4, 1e-9);  // 4 m wide, 1 m deep
  EXPECT_NEAR(state.depth, 1, 1e-9);
  EXPECT_NEAR(state.mean_speed, -2, 1e-9);
  EXPECT_NEAR(state.greatest_speed, 3, 1e-9);
  ASSERT_EQ(state.layers.size(), 2u);
  EXPECT_NEAR(state.layers[0].height, 0.25, 1e-12);
  EXPECT_NEAR(state.layers[0].area, 2, 1e-9);
  EXPECT_NEAR(state.layers[0].speed, -1, 1e-9);
  EXPECT_NEAR(state.layers[1].speed, -3, 1e-9);
}

// 2.5 m are three strips of 0.83 m, in the last of which are two rows of the flow, 1 m wide.
TEST(SectionState, FindsTheDepthAtTheEndOfALineToo) {
  const SectionSlab slab(Polyline{{{10, 5.5, 0}, {10, 3, 0}}, false}, slab_spacing, density);
  EXPECT_NEAR(slab.measure(level_ground(), channel_flow()).depth, 1.2, 1e-9);
}

TEST(SectionState, TurnsItsSignWithTheLine) {
  const SectionSlab slab(Polyline{{{10, 0, 0}, {10, 4, 0}}, false}, slab_spacing, density);
  EXPECT_NEAR(slab.measure(level_ground(), channel_flow()).mean_speed, 2, 1e-9);
}

TEST(SectionState, IsZeroWhereNothingFlows) {
  const SectionSlab slab(Polyline{{{10, 5, 0}, {10, 6, 0}}, false}, slab_spacing, density);
  const SectionState state = slab.measure(level_ground(), channel_flow());
  EXPECT_EQ(state.area, 0);
  EXPECT_EQ(state.mean_speed, 0);
  EXPECT_TRUE(state.layers.empty());
}

}  // namespace
}  // namespace sabo
