#include "geometry/mesh_distance.hpp"

#include <cmath>

#include "geometry/inside_map.hpp"
#include "geometry/solid_angle.hpp"
#include "support/meshes.hpp"
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace sabo {
namespace {

double distance(const MeshDistance& mesh, const Vec3d& point) {
  const auto found = mesh.nearest(point, 100);
  return found ? found->distance : -1;
}

TEST(MeshDistance, OfACubeToFaceEdgeAndCorner) {
  const MeshDistance cube(box_mesh(test::unit_box()));
  EXPECT_NEAR(distance(cube, {0.4, 0.3, 2.5}), 1.5, 1e-15);
  EXPECT_NEAR(distance(cube, {4, 5, 0.5}), 5, 1e-15);        // 3, 4 from the edge x = y = 1
  EXPECT_NEAR(distance(cube, {-1, -2, 3}), 3, 1e-15);        // 1, 2, 2 from the corner
  EXPECT_NEAR(distance(cube, {0.5, 0.3, 0.6}), 0.3, 1e-15);  // from inside
  EXPECT_NEAR(norm(cube.nearest({0.5, 0.3, 0.6}, 1)->point - Vec3d{0.5, 0, 0.6}), 0, 1e-15);
}

TEST(MeshDistance, KeepsToItsReach) {
  const MeshDistance cube(box_mesh(test::unit_box()));
  EXPECT_FALSE(cube.nearest({0.5, 0.5, 1.5}, 0.49));
  EXPECT_TRUE(cube.nearest({0.5, 0.5, 1.5}, 0.5));
}

TEST(MeshDistance, TakesTheNearestThatIsAccepted) {
  const MeshDistance cube(box_mesh(test::unit_box()));
  const auto above_middle = [](const MeshPoint& p) { return p.point.z > 0.5; };
  const auto found = cube.nearest({0.5, 0.3, 0.1}, 10, above_middle);
  ASSERT_TRUE(found);
  // The bottom, the front and the other sides have their nearest points at z = 0 or 0.1.
  EXPECT_NEAR(norm(found->point - Vec3d{0.5, 0.3, 1}), 0, 1e-15);
}

TEST(MeshDistance, InsideIsNotDeceivedByEdges) {
  const MeshDistance cube(box_mesh(test::unit_box()));
  // Every axis-parallel ray from these points meets edges, corners or diagonals of faces.
  for (const double x : {0.25, 0.5, 0.75}) EXPECT_TRUE(cube.is_inside({x, x, x})) << x;
  EXPECT_FALSE(cube.is_inside({0.5, 0.5, 1.5}));
  EXPECT_FALSE(cube.is_inside({1.0, 1.0, 2.0}));
  EXPECT_FALSE(cube.is_inside({-1, 0, 0}));
}

TEST(MeshDistance, FarTrianglesAsDipolesChangeNothing) {
  const TriangleMesh mesh = test::sphere_mesh({0.1, -0.2, 0.3}, 2, 24, 48);
  const MeshDistance sphere(mesh);
  for (int i = -12; i <= 12; ++i)
    for (int k = -12; k <= 12; ++k) {
      const Vec3d point{0.2 * i, 0.05, 0.2 * k};
      EXPECT_EQ(sphere.is_inside(point), winding_number(mesh, point) > 0.5) << i << ' ' << k;
    }
}

TEST(MeshDistance, PartsThatOverlapAreBothInside) {
  TriangleMesh two = box_mesh(test::unit_box());
  append(two, box_mesh({{0.5, 0, 0}, {1.5, 1, 1}, {}, 0}));
  const MeshDistance mesh(two);
  for (const double x : {0.25, 0.75, 1.25}) EXPECT_TRUE(mesh.is_inside({x, 0.4, 0.6})) << x;
  EXPECT_FALSE(mesh.is_inside({1.75, 0.4, 0.6}));
}

RC_GTEST_PROP(MeshDistance, NearestIsNearestOfAllTriangles, ()) {
  const auto part = rc::gen::inRange(-3000, 3000);
  const Vec3d point{*part / 1000.0, *part / 1000.0, *part / 1000.0};
  static const MeshDistance sphere(test::sphere_mesh({0, 0, 0}, 1, 12, 20));
  const auto found = sphere.nearest(point, 10);
  RC_ASSERT(found.has_value());
  RC_ASSERT(std::abs(norm(found->point - point) - found->distance) < 1e-12);
  for (const Vec3d& vertex : sphere.mesh().vertices)
    RC_ASSERT(norm(vertex - point) >= found->distance - 1e-12);
  // The polyhedron lies between the sphere and one of 0.95 of its radius.
  const double radius = norm(point);
  RC_ASSERT(found->distance <= std::abs(radius - 1) + 0.05);
  RC_ASSERT(found->distance >= std::abs(radius - 0.975) - 0.0251);
}

TEST(InsideMap, AgreesWithTheMesh) {
  const auto sphere = std::make_shared<MeshDistance>(test::sphere_mesh({0, 0, 0}, 1, 12, 20));
  const InsideMap map(sphere, 0.1);
  for (int i = -23; i <= 23; ++i)
    for (int j = -23; j <= 23; ++j)
      for (int k = -23; k <= 23; ++k) {
        const Vec3d point{0.0503 * i, 0.0503 * j, 0.0503 * k};
        ASSERT_EQ(map.is_inside(point), sphere->is_inside(point)) << i << ' ' << j << ' ' << k;
      }
}

}  // namespace
}  // namespace sabo
