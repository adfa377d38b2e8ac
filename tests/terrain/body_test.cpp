#include "terrain/body.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "rasters.hpp"
#include "support/ground.hpp"
#include "support/meshes.hpp"
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "terrain/body_points.hpp"
#include "terrain/ground.hpp"

namespace sabo {
namespace {

constexpr double dp = 0.1;
constexpr double reach = 3 * dp;
constexpr double density = 1000;

Body box_body(const UprightBox& box) {
  return {"box", box_mesh(box), FlowSide::outside, reach, {box}};
}

double mass_of(const std::vector<GroundPoint>& points) {
  double sum = 0;
  for (const GroundPoint& p : points) sum += p.mass;
  return sum;
}

/// Signed distance behind the surface of a body, m.
double depth_of(const Body& body, const Vec3d& x) {
  return (body.is_behind(x) ? 1 : -1) * body.distance().nearest(x, 100)->distance;
}

double least_distance(const std::vector<GroundPoint>& points) {
  double least = 1e9;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      least = std::min(least, norm(points[i].position - points[j].position));
  return least;
}

TEST(Body, ABoxIsSolidThroughout) {
  const Body body = box_body({{0, 0, 0}, {2, 1, 1}, {}, 0});
  EXPECT_TRUE(body.contains({1, 0.5, 0.5}));
  EXPECT_TRUE(body.contains({1.99, 0.01, 0.99}));
  EXPECT_FALSE(body.contains({2.01, 0.5, 0.5}));
}

TEST(Body, AMeshWithTheFlowInItIsAShell) {
  const Body body("pipe", box_mesh({{0, 0, 0}, {2, 1, 1}, {}, 0}), FlowSide::inside, reach);
  EXPECT_FALSE(body.contains({1, 0.5, 0.5}));
  EXPECT_TRUE(body.contains({1, -0.29, 0.5}));
  EXPECT_FALSE(body.contains({1, -0.31, 0.5}));
  EXPECT_FALSE(body.contains({-0.29, -0.29, 0.5}));  // farther than 0.3 from the edge
}

TEST(Body, WayOutIsTheNearestThatIsAccepted) {
  const Body body = box_body({{0, 0, 0}, {2, 1, 1}, {}, 0});
  const auto any = [](const Vec3d&) { return true; };
  const Vec3d side = *body.way_out({0.2, 0.5, 0.5}, 0.001, any);
  EXPECT_NEAR(norm(side - Vec3d{-0.001, 0.5, 0.5}), 0, 1e-12);
  // Near the bottom, which stands on the ground.
  const auto above = [](const Vec3d& p) { return p.z > 0; };
  const Vec3d out = *body.way_out({0.2, 0.5, 0.05}, 0.001, above);
  EXPECT_NEAR(norm(out - Vec3d{-0.001, 0.5, 0.05}), 0, 1e-12);
  // From the very surface.
  const Vec3d from_surface = *body.way_out({1, 0.5, 1}, 0.001, any);
  EXPECT_NEAR(norm(from_surface - Vec3d{1, 0.5, 1.001}), 0, 1e-12);
}

TEST(Body, AShellIsLeftOnTheNearerSide) {
  const Body body("pipe", box_mesh({{0, 0, 0}, {2, 1, 1}, {}, 0}), FlowSide::inside, reach);
  const auto any = [](const Vec3d&) { return true; };
  EXPECT_NEAR(norm(*body.way_out({1, -0.1, 0.5}, 0.001, any) - Vec3d{1, 0.001, 0.5}), 0, 1e-12);
  EXPECT_NEAR(norm(*body.way_out({1, -0.2, 0.5}, 0.001, any) - Vec3d{1, -0.301, 0.5}), 0, 1e-12);
}

TEST(BodyPoints, FillASmallBoxExactly) {
  // 5 x 4 x 3 particles, none deeper than the reach.
  const Body body = box_body({{0, 0, 0}, {0.5, 0.4, 0.3}, {0, 0, 0}, 0.4});
  const std::vector<GroundPoint> points = body_points(body, dp, density);
  EXPECT_EQ(points.size(), 60u);
  EXPECT_NEAR(mass_of(points), density * 0.06, 1e-9);
  EXPECT_NEAR(least_distance(points), dp, 1e-9);
  std::size_t nearest = 0;
  for (const GroundPoint& p : points) {
    EXPECT_GE(depth_of(body, p.position), dp / 2 - 1e-9);
    nearest += depth_of(body, p.position) < dp / 2 + 1e-9;
  }
  EXPECT_EQ(nearest, 60u - 3 * 2 * 1);
}

TEST(BodyPoints, OfALargeBoxAreLayersToTheReach) {
  const Body body = box_body({{0, 0, 0}, {2, 2, 2}, {}, 0});
  const std::vector<GroundPoint> points = body_points(body, dp, density);
  EXPECT_EQ(points.size(), 20u * 20 * 20 - 14 * 14 * 14);
  EXPECT_NEAR(mass_of(points), density * (8 - 1.4 * 1.4 * 1.4), 1e-6);
}

TEST(BodyPoints, KeepHalfASpacingWhateverTheSize) {
  for (const double side : {0.23, 0.31, 0.555, 0.99}) {
    const Body body = box_body({{0, 0, 0}, {side, side, side}, {}, 0});
    const std::vector<GroundPoint> points = body_points(body, dp, density);
    double nearest = 1;
    for (const GroundPoint& p : points) nearest = std::min(nearest, depth_of(body, p.position));
    EXPECT_NEAR(nearest, dp / 2, 1e-9) << side;
    EXPECT_GE(least_distance(points), 0.6 * dp) << side;
    if (side < 2 * reach) {
      EXPECT_NEAR(mass_of(points), density * side * side * side, 1e-9);
    }
  }
}

TEST(BodyPoints, OfATankFillItsWallsAndFloor) {
  const UprightBox inside{{0, 0, 0}, {1, 0.8, 0.6}, {}, 0};
  const Body body("tank", tank_mesh(inside, reach, true), FlowSide::outside, reach,
                  tank_boxes(inside, reach, true));
  const std::vector<GroundPoint> points = body_points(body, dp, density);
  EXPECT_EQ(points.size(), 16u * 14 * 9 - 10 * 8 * 6);
  EXPECT_NEAR(mass_of(points), density * (1.6 * 1.4 * 0.9 - 0.48), 1e-9);
  EXPECT_NEAR(least_distance(points), dp, 1e-9);
  for (const GroundPoint& p : points) EXPECT_GE(depth_of(body, p.position), dp / 2 - 1e-9);
}

/// What the flow feels of a wall: the share of its kernel that lies in it, at half a spacing
/// from the wall, over that of a lattice along the wall.
double share_in(const std::vector<GroundPoint>& points, const Vec3d& x) {
  const double h = 1.5 * dp;
  double sum = 0;
  for (const GroundPoint& p : points) {
    const double q = norm(p.position - x) / h;
    if (q < 2)
      sum += p.mass / density * 21 / (16 * std::numbers::pi * h * h * h) * std::pow(1 - q / 2, 4) *
             (1 + 2 * q);
  }
  return sum;
}

TEST(ShellPoints, OfABoxAlongTheAxesAreItsLattice) {
  const Body body("mesh", box_mesh({{0, 0, 0}, {1, 1, 1}, {}, 0}), FlowSide::outside, reach);
  const std::vector<GroundPoint> points = body_points(body, dp, density);
  EXPECT_EQ(points.size(), 1000u - 64);
  EXPECT_NEAR(mass_of(points), density * (1 - 0.064), 1e-6);
  for (const GroundPoint& p : points) EXPECT_NEAR(p.mass, density * dp * dp * dp, 1e-9);
}

TEST(ShellPoints, OfATurnedBoxAreEven) {
  const UprightBox box{{0, 0, 0}, {1.4, 1, 1}, {}, 0.5};
  const Body mesh("mesh", box_mesh(box), FlowSide::outside, reach);
  const std::vector<GroundPoint> points = body_points(mesh, dp, density);
  const std::vector<GroundPoint> lattice = body_points(box_body(box), dp, density);
  // Counted on a lattice of a third of a spacing.
  EXPECT_NEAR(mass_of(points), mass_of(lattice), 0.01 * mass_of(lattice));
  EXPECT_NEAR(double(points.size()), double(lattice.size()), 0.1 * double(lattice.size()));
  EXPECT_GE(least_distance(points), 0.55 * dp);
  for (const GroundPoint& p : points) EXPECT_GE(depth_of(mesh, p.position), dp / 2 - 1e-6);
  // Along a face, across an edge and at a corner.
  double least = 1, most = 0, sum = 0;
  int count = 0;
  for (double x = 0.05; x < 1.4; x += 0.0437)
    for (double y = 0.05; y < 1; y += 0.0371) {
      const Vec3d on_top = box.turned({x, y, 1 + dp / 2});
      const Vec3d at_side = box.turned({x, -dp / 2, y});
      for (const Vec3d& at : {on_top, at_side}) {
        const double ratio = share_in(points, at) / share_in(lattice, at);
        least = std::min(least, ratio);
        most = std::max(most, ratio);
        sum += ratio;
        ++count;
      }
    }
  EXPECT_NEAR(sum / count, 1, 0.03);  // the second layer lies where the cells put it
  EXPECT_GT(least, 0.85);
  EXPECT_LT(most, 1.15);
}

TEST(ShellPoints, HaveNoGaps) {
  const Body sphere("sphere", test::sphere_mesh({0, 0, 0}, 0.8, 24, 48), FlowSide::outside, reach);
  const Body hollow("hollow", test::sphere_mesh({0, 0, 0}, 0.8, 24, 48), FlowSide::inside, reach);
  for (const Body* body : {&sphere, &hollow}) {
    const std::vector<GroundPoint> points = body_points(*body, dp, density);
    const double outer = body == &sphere ? 0.8 : 1.1, inner = outer - 0.3;
    const double shell = 4.0 / 3 * std::numbers::pi * (std::pow(outer, 3) - std::pow(inner, 3));
    EXPECT_NEAR(mass_of(points), density * shell, 0.03 * density * shell);
    for (int k = 0; k < 400; ++k) {  // evenly on the sphere, by the golden angle
      const double z = 1 - (k + 0.5) / 200, r = std::sqrt(1 - z * z), turn = 2.399963 * k;
      const Vec3d at = 0.8 * Vec3d{r * std::cos(turn), r * std::sin(turn), z};
      double nearest = 1;
      for (const GroundPoint& p : points) nearest = std::min(nearest, norm(p.position - at));
      EXPECT_LT(nearest, 1.05 * dp) << body->name() << ' ' << k;
      EXPECT_GT(nearest, 0.45 * dp) << body->name() << ' ' << k;
    }
  }
}

TEST(ShellPoints, FillAPlateThinnerThanASpacing) {
  const Body plate("plate", box_mesh({{0, 0, 0}, {1, 1, 0.06}, {}, 0}), FlowSide::outside, reach);
  const std::vector<GroundPoint> points = body_points(plate, dp, density);
  EXPECT_GE(points.size(), 90u);
  for (const GroundPoint& p : points) EXPECT_NEAR(p.position.z, 0.03, 0.02);
  const Body foil("foil", box_mesh({{0, 0, 0}, {1, 1, 0.001}, {}, 0}), FlowSide::outside, reach);
  EXPECT_THROW(body_points(foil, dp, density), CaseError);
}

TEST(BodyPoints, RefuseABodyOutOfAllProportion) {
  const Body body = box_body({{0, 0, 0}, {1000, 1000, 1000}, {}, 0});
  EXPECT_THROW(body_points(body, dp, density), CaseError);
}

// ---- in the ground ----

Surface flat_yard() { return Surface(Raster(square_grid(-5, 5, 0.5), 0)); }

Particles all_of(Ground& ground) {
  std::vector<Vec3d> fluid;
  for (double x = -5; x <= 5; x += 0.2)
    for (double y = -5; y <= 5; y += 0.2) fluid.push_back({x, y, 0.2});
  Particles boundary;
  test::follow(ground, fluid, 0.5, boundary);
  return boundary;
}

TEST(GroundWithBody, HasItsParticlesAboveTheGroundOnceAndNumbered) {
  const Surface surface = flat_yard();
  CheckDam dam;
  dam.axis = {{{-3, -1, 0}, {-3, 1, 0}}, false};
  dam.crest = 0.5;
  dam.thickness = 0.4;
  const Body sunk = box_body({{0, 0, -0.5}, {1, 1, 0.5}, {}, 0});
  const Body on_it = box_body({{0.5, 0, 0}, {1.5, 1, 0.5}, {}, 0});
  Ground ground(surface, {dam}, {dp, 3, density}, {sunk, on_it});
  const Particles boundary = all_of(ground);
  std::map<int, double> volume, foundation;
  for (std::size_t k = 0; k < boundary.size(); ++k) {
    const bool is_above = boundary.position[k].z > 0;
    const bool is_foundation = boundary.body[k] >= foundation_mark;
    EXPECT_FALSE(is_above && (is_foundation || boundary.body[k] == 0));
    EXPECT_TRUE(is_above || is_foundation || boundary.body[k] == 0);
    (is_above ? volume : foundation)[boundary.body[k] & most_bodies] += boundary.mass[k] / density;
  }
  EXPECT_NEAR(volume[1], 2 * 0.4 * 0.5, 1e-9);
  // The core deeper than three spacings is empty: 4 x 4 of the upper two rows.
  EXPECT_NEAR(volume[2], 0.5 - 4 * 4 * 2 * 0.001, 1e-9);
  EXPECT_NEAR(volume[3], 0.25, 1e-9);  // the half that is not in the first
  // The ground under them, three layers of 0.1 m, is of the first that stands there.
  for (std::size_t k = 0; k < boundary.size(); ++k) {
    const Vec3d& x = boundary.position[k];
    if ((boundary.body[k] & most_bodies) != 3) continue;
    EXPECT_TRUE(x.x > 1 && x.x < 1.5 && x.y > 0 && x.y < 1) << x.x << ' ' << x.y;
  }
  EXPECT_NEAR(foundation[1], 2 * 0.4 * 0.3, 1e-9);
  EXPECT_NEAR(foundation[2], 0.3, 1e-9);
  EXPECT_NEAR(foundation[3], 0.15, 1e-9);
}

TEST(GroundWithBody, LeavesTheGroundUnderAnOpeningToTheGround) {
  const Surface surface = flat_yard();
  CheckDam dam;
  dam.axis = {{{0, -2, 0}, {0, 2, 0}}, false};
  dam.crest = 1;
  dam.thickness = 0.4;
  dam.openings = {{1.5, 2.5}};                                       // a slit from the ground up
  const Body lintel = box_body({{1, -1, 0.2}, {2, 1, 0.5}, {}, 0});  // touches it nowhere
  Ground ground(surface, {dam}, {dp, 3, density}, {lintel});
  const Particles boundary = all_of(ground);
  double foundation = 0;
  for (std::size_t k = 0; k < boundary.size(); ++k)
    if (boundary.position[k].z < 0 && boundary.body[k] > 0)
      foundation += boundary.mass[k] / density;
  EXPECT_NEAR(foundation, 3 * 0.4 * 0.3, 1e-9);
}

TEST(GroundWithBody, MakesItNearTheFlowOnly) {
  const Surface surface = flat_yard();
  const Body wall = box_body({{-4.5, -0.2, 0}, {4.5, 0.2, 1}, {}, 0});
  Ground ground(surface, {}, {dp, 3, density}, {wall});
  Particles boundary;
  test::follow(ground, {{0, 0.5, 0.2}}, 0.4, boundary);
  std::size_t count = 0;
  for (std::size_t k = 0; k < boundary.size(); ++k) {
    if (boundary.body[k] == 0) continue;
    ++count;
    EXPECT_LT(std::abs(boundary.position[k].x), 0.4 + 0.8);
  }
  EXPECT_GT(count, 100u);
  test::follow(ground, {{0, 4, 0.2}}, 0.4, boundary);
  for (std::size_t k = 0; k < boundary.size(); ++k) EXPECT_EQ(boundary.body[k], 0);
}

TEST(GroundWithBody, PushesOutOfEverything) {
  const Surface surface = flat_yard();
  const UprightBox inside{{-3, -3, 0}, {-1, -1, 1}, {-2, -2, 0}, 0.3};
  const Body tank("tank", tank_mesh(inside, reach, true), FlowSide::outside, reach,
                  tank_boxes(inside, reach, true));
  const Body ball("ball", test::sphere_mesh({1, 1, 0.3}, 0.5, 12, 24), FlowSide::outside, reach);
  const Ground ground(surface, {}, {dp, 3, density}, {tank, ball});
  Random random;
  for (int trial = 0; trial < 2000; ++trial) {
    const Vec3d point{6 * random() - 4, 6 * random() - 4, 2 * random() - 0.5};
    const Vec3d moved = ground.pushed_out(point);
    EXPECT_FALSE(ball.contains(moved) || tank.contains(moved));
    EXPECT_FALSE(ground.is_solid(moved)) << point.x << ' ' << point.y << ' ' << point.z;
    if (point.z > 0 && ground.is_solid(point)) {
      EXPECT_LT(norm(moved - point), 0.5) << point.x << ' ' << point.y << ' ' << point.z;
    }
  }
  EXPECT_TRUE(ground.is_solid({1, 1, 0.3}));
  EXPECT_TRUE(ground.is_solid(inside.turned({-3.1, -2, 0.5})));
  EXPECT_FALSE(ground.is_solid({-2, -2, 0.5}));  // the inside of the tank is free
  EXPECT_FALSE(ground.is_solid({-2, -2, 3}));
}

TEST(GroundWithBody, RefusesABodyBelowTheGroundOrBeside) {
  const Surface surface = flat_yard();
  EXPECT_THROW(Ground(surface, {}, {dp, 3, density}, {box_body({{0, 0, -2}, {1, 1, -1}, {}, 0})}),
               CaseError);
  EXPECT_THROW(Ground(surface, {}, {dp, 3, density}, {box_body({{20, 0, 0}, {21, 1, 1}, {}, 0})}),
               CaseError);
}

}  // namespace
}  // namespace sabo
