#include <algorithm>
#include <cmath>
#include <set>

#include "rasters.hpp"
#include "support/meshes.hpp"
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "terrain/release.hpp"

namespace sabo {
namespace {

const ReleaseSettings settings{0.1, 1000, {}};

double mass_of(const Particles& p) {
  double sum = 0;
  for (const double mass : p.mass) sum += mass;
  return sum;
}

TEST(ReleasedBox, FitsItsSidesWhateverTheirLength) {
  const Surface surface(Raster(square_grid(-5, 5, 0.5), 0));
  const Bounds box{{0.03, 0.05, 0.2}, {1.06, 0.55, 0.61}};
  const Particles p = released_box(surface, box, {}, settings);
  EXPECT_EQ(p.size(), 10u * 5 * 4);
  EXPECT_NEAR(mass_of(p), 1000 * 1.03 * 0.5 * 0.41, 1e-9);
  std::set<double> x, z;
  for (const Vec3d& at : p.position) {
    x.insert(at.x);
    z.insert(at.z);
  }
  EXPECT_NEAR(*x.begin() - 0.03, 1.03 / 20, 1e-12);
  EXPECT_NEAR(1.06 - *x.rbegin(), 1.03 / 20, 1e-12);
  EXPECT_NEAR(*z.begin() - 0.2, 0.41 / 8, 1e-12);
}

TEST(ReleasedBox, StandsOnTheGroundWithALevelTop) {
  const Surface slope(raster_of(square_grid(-5, 5, 0.5), [](double x, double) { return 0.5 * x; }));
  const Particles p = released_box(slope, {{0, 0, -9}, {1, 1, 1}}, {}, settings);
  // Under z = 1, over 0.5 x: 1 - 0.25.
  EXPECT_NEAR(mass_of(p), 750, 2);
  double top = 0;
  for (const Vec3d& at : p.position) {
    EXPECT_GT(at.z - 0.5 * at.x, 0.04);
    top = std::max(top, at.z);
  }
  EXPECT_NEAR(top, 0.95, 0.01);
}

TEST(ReleasedBox, LeavesBodiesOut) {
  const Surface surface(Raster(square_grid(-5, 5, 0.5), 0));
  const UprightBox inner{{0.3, 0.3, 0}, {0.6, 0.7, 0.5}, {}, 0};
  const Body body("box", box_mesh(inner), FlowSide::outside, 0.3, {inner});
  const Particles p = released_box(surface, {{0, 0, 0}, {1, 1, 1}}, {body}, settings);
  EXPECT_EQ(p.size(), 1000u - 3 * 4 * 5);
  EXPECT_NEAR(mass_of(p), 1000 - 60, 1e-9);
  for (const Vec3d& at : p.position) EXPECT_FALSE(body.contains(at));
}

TEST(ReleasedBox, RefusesABoxBesideTheGroundOrBelow) {
  const Surface surface(Raster(square_grid(-5, 5, 0.5), 0));
  EXPECT_THROW(released_box(surface, {{4, 4, 0}, {6, 5, 1}}, {}, settings), CaseError);
  EXPECT_THROW(released_box(surface, {{0, 0, -2}, {1, 1, -1}}, {}, settings), CaseError);
  EXPECT_THROW(released_box(surface, {{0, 0, 0}, {1, 1, 1e9}}, {}, settings), CaseError);
}

}  // namespace
}  // namespace sabo
