#include <algorithm>
#include <tuple>

#include "support/scenes.hpp"
#include <gtest/gtest.h>

namespace sabo {
namespace {

// 1 m of water on each of 1.03 x 0.52 m at 0.1 m: 10 x 5 x 10 cells of 0.103 x 0.104 x 0.1 m.
TEST(Box, IsFilledExactly) {
  const FlowModel model = test::plain_model(0.1, 30, 1);
  Particles water;
  add_box(water, model, {{2, 1, 0}, {3.03, 1.52, 1}}, 7);
  ASSERT_EQ(water.size(), 500u);
  EXPECT_NEAR(test::mass_of(water), 1030 * 0.52, 1e-9);
  EXPECT_NEAR(water.position[0].x, 2 + 0.0515, 1e-12);
  EXPECT_NEAR(water.position.back().y, 1.52 - 0.052, 1e-12);
  EXPECT_EQ(water.body.back(), 7);
  FlowModel flat = model;
  flat.dimension = 2;
  Particles sheet;
  add_box(sheet, flat, {{2, 1, 0}, {3.03, 1.52, 1}});
  ASSERT_EQ(sheet.size(), 100u);
  EXPECT_NEAR(test::mass_of(sheet), 1030, 1e-9);
  EXPECT_EQ(sheet.position.back().y, 0);
}

// 1000 kg/m3 x 9.81 m/s2 over 0.95 m above the lowest particles.
TEST(Box, OfStillWaterCarriesItsWeight) {
  const FlowModel model = test::plain_model(0.1, 100, 1);
  Particles water;
  add_still_box(water, model, {{0, 0, 3}, {0.3, 0.3, 4}});
  EXPECT_NEAR(model.state.pressure(water.density.front()), 9319.5, 1e-6);
  EXPECT_NEAR(model.state.pressure(water.density.back()), 490.5, 1e-6);
}

// A box of 1 x 0.5 x 0.4 m with walls of 0.3 m: 1.6 x 1.1 x 0.7 m without the box.
TEST(Tank, HasWallsOfTheKernelOnFiveSides) {
  const FlowModel model = test::plain_model(0.1, 30, 1);
  const Box inner{{0, 0, 0}, {1, 0.5, 0.4}};
  Particles walls;
  Tank{inner}.add_to(walls, model);
  EXPECT_EQ(walls.size(), 16u * 11 * 7 - 10 * 5 * 4);
  EXPECT_NEAR(test::mass_of(walls), static_cast<double>(walls.size()), 1e-9);  // 1 kg each
  for (const Vec3d& x : walls.position)
    EXPECT_FALSE(x.x > 0 && x.x < 1 && x.y > 0 && x.y < 0.5 && x.z > 0);
  std::sort(walls.position.begin(), walls.position.end(), [](const Vec3d& a, const Vec3d& b) {
    return std::tuple(a.x, a.y, a.z) < std::tuple(b.x, b.y, b.z);
  });
  for (std::size_t i = 1; i < walls.size(); ++i)
    EXPECT_GT(norm(walls.position[i] - walls.position[i - 1]), 0.09);

  FlowModel flat = model;
  flat.dimension = 2;
  Particles sheet;
  Tank{inner, 1}.add_to(sheet, flat);
  EXPECT_EQ(sheet.size(), 12u + 2 * 4);
}

// A column of 0.2 x 0.3 m on a floor three layers thick: 2 x 3 x 3 particles of it.
TEST(Foundation, IsTheFloorUnderABox) {
  const FlowModel model = test::plain_model(0.1, 30, 1);
  Particles walls;
  Tank{{{0, 0, 0}, {1, 0.5, 0.4}}}.add_to(walls, model);
  const Box column{{0.4, 0.1, 0}, {0.6, 0.4, 0.4}};
  add_box(walls, model, column, 2);
  mark_foundation(walls, column, 2);
  std::size_t count = 0;
  for (std::size_t b = 0; b < walls.size(); ++b) {
    if (walls.position[b].z > 0) continue;
    const bool is_under = walls.position[b].x > 0.4 && walls.position[b].x < 0.6 &&
                          walls.position[b].y > 0.1 && walls.position[b].y < 0.4;
    EXPECT_EQ(walls.body[b], is_under ? 2 | foundation_mark : 0);
    count += is_under ? 1 : 0;
  }
  EXPECT_EQ(count, 2u * 3 * 3);
}

}  // namespace
}  // namespace sabo
