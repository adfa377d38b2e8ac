#include "terrain/release.hpp"

#include <cmath>
#include <numeric>

#include "rasters.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"

namespace sabo {
namespace {

using testing::HasSubstr;

Surface slope() {
  return Surface(raster_of(square_grid(0, 20, 1), [](double x, double) { return 0.75 * x; }));
}

double volume_of(const Particles& particles, double density) {
  return std::accumulate(particles.mass.begin(), particles.mass.end(), 0.0) / density;
}

TEST(Release, StandsOnTheGroundInColumns) {
  const Surface surface = slope();
  const Particles fluid = released(surface, release_of({{square(4, 8), 1.6}}), {0.5, 1700, {}});
  ASSERT_EQ(fluid.size(), 8U * 8 * 3);
  // Three share 1.6 m.
  EXPECT_DOUBLE_EQ(fluid.position[0].z, 0.75 * 4.25 + 1.6 / 6);
  EXPECT_DOUBLE_EQ(fluid.position[2].z, 0.75 * 4.25 + 5 * 1.6 / 6);
  EXPECT_EQ(fluid.position[2].x, 4.25);
  for (std::size_t k = 0; k < fluid.size(); ++k) {
    EXPECT_EQ(fluid.id[k], k);
    EXPECT_EQ(fluid.mass[k], fluid.mass[0]);
    EXPECT_EQ(fluid.density[k], 1700);
    EXPECT_EQ(fluid.velocity[k], Vec3d{});
  }
  EXPECT_NEAR(volume_of(fluid, 1700), 16 * 1.6, 1e-10);
}

TEST(Release, ScalesToAVolume) {
  const Surface surface = slope();
  const ReleaseShape shape = scaled_to(release_of({{square(4, 8), 1.6}}), 48);
  EXPECT_DOUBLE_EQ(shape.thickness(5, 5), 3);
  EXPECT_DOUBLE_EQ(shape.area, 16);
  EXPECT_NEAR(volume_of(released(surface, shape, {0.4, 1700, {}}), 1700), 48, 1e-10);
}

TEST(Release, NormalThicknessBecomesVertical) {
  const Surface surface = slope();  // 3-4-5: the normal's z is 0.8
  const ReleaseShape shape = made_vertical(release_of({{square(4, 8), 1.6}}), surface, 0.5);
  EXPECT_DOUBLE_EQ(shape.thickness(5, 5), 2);
  EXPECT_EQ(shape.thickness(9, 5), 0);
  EXPECT_NEAR(shape.volume, 32, 1e-10);
}

TEST(Release, TakesThicknessFromARaster) {
  Raster thickness({4, 4, 2, 10, 2, 2}, Raster::no_data);
  thickness.at(1, 1) = 1;  // x 4 to 6, y 6 to 8
  thickness.at(2, 1) = 2;
  thickness.at(3, 3) = -5;
  const Surface surface = slope();
  const ReleaseShape shape = release_of(thickness);
  EXPECT_DOUBLE_EQ(shape.volume, 12);
  EXPECT_DOUBLE_EQ(shape.area, 8);
  const Particles fluid = released(surface, shape, {0.5, 1000, {}});
  EXPECT_EQ(fluid.size(), 16U * 2 + 16 * 4);
  EXPECT_NEAR(volume_of(fluid, 1000), 12, 1e-10);
}

// 1.4 m are one particle of a spacing of 1 m, 2.6 m are three.
TEST(Release, HasTheVolumeWhereItIs) {
  Raster thickness({2, 1, 0, 10, 10, 10}, 1.4);
  thickness.at(1, 0) = 2.6;
  const Surface surface = slope();
  const Particles fluid = released(surface, release_of(thickness), {1, 1000, {}});
  ASSERT_EQ(fluid.size(), 100U + 300);
  for (std::size_t k = 0; k < fluid.size(); ++k)
    EXPECT_NEAR(fluid.mass[k], fluid.position[k].x < 10 ? 1400 : 2600. / 3, 1e-9);
}

// What is too thin for particles of its own: 0.2 m in 100 columns are 33 particles of 0.6 m, one in
// three of them, and 0.2 m that all share.
TEST(Release, GathersWhatIsThinWhereItLies) {
  Raster thickness({2, 1, 0, 10, 10, 10}, 0.2);
  thickness.at(1, 0) = 1;
  const Surface surface = slope();
  const Particles fluid = released(surface, release_of(thickness), {1, 1000, {}});
  ASSERT_EQ(fluid.size(), 33U + 100);
  double thin = 0;
  for (std::size_t k = 0; k < fluid.size(); ++k)
    if (fluid.position[k].x < 10) {
      EXPECT_NEAR(fluid.mass[k], 600, 1.1);
      EXPECT_NEAR(fluid.position[k].z - surface.height(fluid.position[k].x, 5), 0.3, 1e-9);
      thin += fluid.mass[k] / 1000;
    }
  EXPECT_NEAR(thin, 20, 0.3);
  EXPECT_NEAR(volume_of(fluid, 1000), 120, 1e-9);
}

TEST(Release, RefusesWhatIsOutsideTheDemAndNamesThePlace) {
  const Surface surface = slope();
  const Frame frame{600000, 4000000, ""};
  try {
    released(surface, release_of({{square(18, 22), 1}}), {1, 1000, frame});
    FAIL();
  } catch (const CaseError& error) {
    EXPECT_THAT(error.what(), HasSubstr("outside the DEM at (600018.50, 4000020.50)"));
    EXPECT_THAT(error.what(), HasSubstr("within x 6"));
  }
  EXPECT_THROW(released(surface, {{3, 3, 3}, {3, 30, 3}}, 1, {1, 1000, {}}), CaseError);
}

TEST(Release, RefusesTooThinAndTooLarge) {
  const Surface surface = slope();
  // 0.48 m3, less than half a particle in all.
  const ReleaseShape shape = release_of({{square(4, 8), 0.03}});
  try {
    released(surface, shape, {1, 1000, {}});
    FAIL();
  } catch (const CaseError& error) {
    EXPECT_THAT(error.what(), HasSubstr("smaller spacing"));
  }
  EXPECT_THROW(released(surface, shape, {1e-4, 1000, {}}), CaseError);
  EXPECT_THROW(release_of({{square(4, 4), 1}}), CaseError);
  EXPECT_THROW(release_of(Raster({2, 2, 0, 0, 1, 1}, Raster::no_data)), CaseError);
}

TEST(ReleasePoints, AreTheParticlesAtTheirOwnSpacing) {
  const Surface surface = slope();
  const std::vector<Vec3d> points{{5, 5, 6}, {5.75, 5, 6.3}};
  const Particles fluid = released(surface, points, 0.75 * 0.75 * 0.75, {0.75, 1730, {}});
  EXPECT_EQ(fluid.position, points);
  EXPECT_NEAR(volume_of(fluid, 1730), 2 * 0.421875, 1e-12);
}

TEST(ReleasePoints, AreResampledAtAnotherSpacing) {
  const Surface surface = slope();
  // Two cubes of side 1, of which the second overlaps the first by half.
  const std::vector<Vec3d> points{{5.5, 5.5, 8.5}, {6, 5.5, 8.5}};
  const Particles fluid = released(surface, points, 1, {0.5, 1000, {}});
  EXPECT_EQ(fluid.size(), 3U * 2 * 2);
  EXPECT_NEAR(volume_of(fluid, 1000), 2, 1e-12);
  for (const Vec3d& p : fluid.position) {
    EXPECT_GT(p.x, 5);
    EXPECT_LT(p.x, 6.5);
  }
  // At a spacing of 3 the only site near is (4.5, 4.5, 7.5), in neither cube.
  EXPECT_THROW(released(surface, points, 1, {3, 1000, {}}), CaseError);
}

}  // namespace
}  // namespace sabo
