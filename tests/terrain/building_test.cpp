#include "terrain/building.hpp"

#include <cmath>
#include <vector>

#include "rasters.hpp"
#include <gtest/gtest.h>

#include "terrain/body_points.hpp"
#include "terrain/ground.hpp"
#include "terrain/polygon_checks.hpp"
#include "terrain/prism_mesh.hpp"

namespace sabo {
namespace {

/// 6 m x 6 m without its quarter at the upper right, clockwise and with a vertex on an edge.
Polygon ell() {
  return {{{{0, 0, 0}, {0, 6, 0}, {3, 6, 0}, {3, 3, 0}, {6, 3, 0}, {6, 0, 0}, {2, 0, 0}}}};
}

TEST(PrismMesh, HoldsThePolygonBetweenItsElevations) {
  const TriangleMesh mesh = prism_mesh(ell(), 1, 5);
  EXPECT_NEAR(volume(mesh), 27 * 4, 1e-9);
  EXPECT_EQ(mesh.vertices.size(), 12u);
  EXPECT_NEAR(area(mesh), 2 * 27 + 24 * 4, 1e-9);
  EXPECT_EQ(bounds_of(mesh).low.z, 1);
  EXPECT_EQ(bounds_of(mesh).high.z, 5);
}

TEST(PrismMesh, HolesAreShafts) {
  Polygon court = square(0, 10);
  court.rings.push_back(square(3, 7).rings[0]);
  const TriangleMesh mesh = prism_mesh(court, 0, 2);
  EXPECT_NEAR(volume(mesh), (100 - 16) * 2, 1e-9);
  const Body body("court", mesh, FlowSide::outside, 1);
  EXPECT_TRUE(body.contains({1, 5, 1}));
  EXPECT_FALSE(body.contains({5, 5, 1}));
}

TEST(PlanPolygons, FaultsAreNamed) {
  EXPECT_EQ(fault_of(ell()), "");
  const Polygon bow{{{{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}}}};
  EXPECT_EQ(fault_of(bow), "Self-intersection[1 1]");
  EXPECT_NE(fault_of({{{{0, 0, 0}, {1, 1, 0}}}}), "");
  EXPECT_NE(fault_of({}), "");
}

TEST(PlanPolygons, ShareTheirOverlapAndNotTheirEdges) {
  EXPECT_NEAR(shared_area(square(0, 4), square(3, 9)), 1, 1e-12);
  EXPECT_EQ(shared_area(square(0, 4), square(4, 9)), 0);
  EXPECT_EQ(shared_area(ell(), square(4, 9)), 0);  // in its missing quarter
}

TEST(Building, ARectangleBecomesABoxOfTheSamePlace) {
  // 4 m x 3 m, turned by atan(3/4), clockwise.
  const Polygon outline{{{{1, 1, 0}, {-0.8, 3.4, 0}, {2.4, 5.8, 0}, {4.2, 3.4, 0}}}};
  const Body body = building_body({"house", "house", outline, 2, 7}, 1, 0.5);
  ASSERT_EQ(body.boxes().size(), 1u);
  EXPECT_NEAR(volume(body.mesh()), 4 * 3 * 5, 1e-9);
  for (const Vec3d& corner : outline.rings[0]) {
    double nearest = 1e9;
    for (const Vec3d& v : body.mesh().vertices)
      nearest = std::min(nearest, std::hypot(v.x - corner.x, v.y - corner.y));
    EXPECT_NEAR(nearest, 0, 1e-9);
  }
  EXPECT_TRUE(building_body({"", "", ell(), 0, 3}, 1, 0.5).boxes().empty());
  const Polygon askew{{{{0, 0, 0}, {4, 0, 0}, {5, 3, 0}, {1, 3, 0}}}};
  EXPECT_TRUE(building_body({"", "", askew, 0, 3}, 1, 0.5).boxes().empty());
}

TEST(Building, StandsOnTheLowestGroundOfItsOutline) {
  const Surface slope(raster_of(square_grid(-20, 20, 1), [](double x, double) { return 0.5 * x; }));
  EXPECT_NEAR(lowest_ground(slope, square(2.3, 8)), 0.5 * 2.3, 1e-9);
  // A pit between its corners counts.
  const Surface pit(raster_of(square_grid(-20, 20, 1),
                              [](double x, double y) { return x == 5 && y == 5 ? -2.0 : 0.0; }));
  EXPECT_EQ(lowest_ground(pit, square(2, 8)), -2);
}

TEST(Building, IsSolidFromTheGroundToItsTopOnASlope) {
  const Surface slope(raster_of(square_grid(-20, 20, 1), [](double x, double) { return 0.5 * x; }));
  const Polygon outline = square(0, 6);
  const Building building{"house", "house", outline, lowest_ground(slope, outline), 8};
  const Ground ground(slope, {}, {0.5, 3, 1000}, {building_body(building, 1.5, 0.5)});
  EXPECT_TRUE(ground.is_solid({0.1, 3, 0.1}));
  EXPECT_TRUE(ground.is_solid({5.9, 3, 3.1}));
  EXPECT_TRUE(ground.is_solid({3, 3, 7.9}));
  EXPECT_FALSE(ground.is_solid({3, 3, 8.1}));
  EXPECT_FALSE(ground.is_solid({-0.1, 3, 0.1}));
  const Vec3d out = ground.pushed_out({0.2, 3, 1});
  EXPECT_NEAR(out.x, 0, 0.01);
}

TEST(Building, ItsParticlesFillTheWallsOfAnyOutline) {
  const Body body = building_body({"house", "house", ell(), 0, 4}, 0.9, 0.3);
  for (const GroundPoint& point : body_points(body, 0.3, 1000)) {
    EXPECT_TRUE(contains(ell(), point.position.x, point.position.y));
    EXPECT_LT(point.position.z, 4);
  }
}

}  // namespace
}  // namespace sabo
