#include "geometry/mesh_topology.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "geometry/plan_outline.hpp"
#include "geometry/solid_angle.hpp"
#include "support/meshes.hpp"
#include <gtest/gtest.h>

namespace sabo {
namespace {

void turn(Triangle& t) { std::swap(t[1], t[2]); }

/// Each triangle with its own three vertices, as in STL.
TriangleMesh exploded(const TriangleMesh& mesh) {
  TriangleMesh result;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto n = static_cast<std::uint32_t>(result.vertices.size());
    for (int k = 0; k < 3; ++k) result.vertices.push_back(mesh.corner(t, k));
    result.triangles.push_back({n, n + 1, n + 2});
  }
  return result;
}

TEST(TriangleMesh, AreaAndVolumeOfABox) {
  const TriangleMesh mesh = box_mesh({{1, 2, 3}, {3, 5, 7}, {10, -4, 0}, 0.3});
  EXPECT_NEAR(area(mesh), 2 * (2 * 3 + 3 * 4 + 4 * 2), 1e-12);
  EXPECT_NEAR(volume(mesh), 24, 1e-12);
}

TEST(TriangleMesh, VolumeOfASphere) {
  const TriangleMesh mesh = test::sphere_mesh({1e5, 2e5, 300}, 2, 16, 24);
  EXPECT_NEAR(volume(mesh), test::sphere_mesh_volume(2, 16, 24), 1e-8);
  EXPECT_NEAR(volume(test::sphere_mesh({}, 2, 100, 200)), 4.0 / 3 * std::numbers::pi * 8, 0.02);
}

TEST(TankMesh, IsItsWallsAndFloor) {
  const UprightBox inside{{0, 0, 0}, {4, 3, 2}, {1, 1, 0}, 0.7};
  TriangleMesh open = tank_mesh(inside, 0.5, true);
  EXPECT_TRUE(orient_outwards(open).is_watertight());
  // Around it 5 x 4 x 2.5, less the inside.
  EXPECT_NEAR(volume(open), 5 * 4 * 2.5 - 24, 1e-12);
  EXPECT_NEAR(volume(tank_mesh(inside, 0.5, true)), 5 * 4 * 2.5 - 24, 1e-12);
  TriangleMesh closed = tank_mesh(inside, 0.5, false);
  EXPECT_NEAR(volume(closed), 5 * 4 * 3 - 24, 1e-12);
  EXPECT_TRUE(orient_outwards(closed).is_watertight());
  EXPECT_NEAR(volume(closed), 5 * 4 * 3 - 24, 1e-12);  // the inside stays a cavity
}

TEST(TankMesh, ItsBoxesFillIt) {
  const UprightBox inside{{0, 0, 0}, {4, 3, 2}, {1, 1, 0}, 0.7};
  for (const bool is_open : {true, false}) {
    double sum = 0;
    for (const UprightBox& box : tank_boxes(inside, 0.5, is_open)) {
      const TriangleMesh mesh = box_mesh(box);
      sum += volume(mesh);
      Vec3d middle;
      for (const Vec3d& v : mesh.vertices) middle += 0.125 * v;
      EXPECT_NEAR(winding_number(tank_mesh(inside, 0.5, is_open), middle), 1, 1e-12);
    }
    EXPECT_NEAR(sum, volume(tank_mesh(inside, 0.5, is_open)), 1e-12);
  }
}

TEST(PlanOutline, IsConvexAndAnticlockwise) {
  TriangleMesh mesh = box_mesh({{0, 0, 0}, {2, 1, 5}, {}, 0});
  append(mesh, box_mesh({{0.5, 0.2, 0}, {1, 0.7, 9}, {}, 0}));
  EXPECT_EQ(plan_outline(mesh), (std::vector<Vec3d>{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}));
}

TEST(Welded, JoinsVerticesWithinTheTolerance) {
  TriangleMesh mesh = exploded(box_mesh(test::unit_box()));
  for (std::size_t k = 0; k < mesh.vertices.size(); ++k)
    mesh.vertices[k].x += 1e-7 * static_cast<double>(k % 3);
  EXPECT_EQ(welded(mesh, 1e-6).vertices.size(), 8u);
  EXPECT_EQ(welded(mesh, 1e-6).triangles.size(), 12u);
  EXPECT_GT(welded(mesh, 1e-9).vertices.size(), 8u);
  mesh.triangles.push_back({0, 0, 1});
  EXPECT_EQ(welded(mesh, 1e-6).triangles.size(), 12u);
}

TEST(OrientOutwards, WhateverTheTrianglesFace) {
  for (unsigned pattern = 0; pattern < 4096; pattern += 37) {
    TriangleMesh mesh = box_mesh(test::unit_box());
    for (std::size_t t = 0; t < 12; ++t)
      if (pattern >> t & 1) turn(mesh.triangles[t]);
    EXPECT_TRUE(orient_outwards(mesh).is_watertight());
    EXPECT_NEAR(volume(mesh), 1, 1e-12);
    EXPECT_NEAR(winding_number(mesh, {0.3, 0.4, 0.5}), 1, 1e-12);
  }
}

TEST(OrientOutwards, CountsOpenEdgesAndNamesOne) {
  TriangleMesh mesh = box_mesh(test::unit_box());
  std::erase_if(mesh.triangles, [](const Triangle& t) { return t == Triangle{4, 5, 6}; });
  const MeshGaps gaps = orient_outwards(mesh);
  EXPECT_FALSE(gaps.is_watertight());
  EXPECT_EQ(gaps.open_edges, 3u);
  // Of a triangle with the corners (0, 0, 1), (1, 0, 1), (1, 1, 1).
  EXPECT_EQ(gaps.open_edge.z, 1);
  const Vec3d edge = gaps.open_edge;
  EXPECT_TRUE((edge == Vec3d{0.5, 0, 1}) || (edge == Vec3d{1, 0.5, 1}) ||
              (edge == Vec3d{0.5, 0.5, 1}));
}

TEST(OrientOutwards, RefusesAMoebiusStripClosedByNothing) {
  // Five triangles in a ring with one twist; edges at its rim are open.
  TriangleMesh strip{{{0, 0, 0}, {1, 0, 1}, {2, 1, 0}, {1, 2, 1}, {0, 1, 0}},
                     {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 0}, {4, 0, 1}}};
  EXPECT_EQ(orient_outwards(strip).open_edges, 5u);
}

TEST(OrientOutwards, RefusesAProjectivePlane) {
  // The six-vertex triangulation: every edge has two triangles, yet it has one side only.
  TriangleMesh plane{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {0, 1, 1}},
                     {{0, 1, 2},
                      {0, 2, 3},
                      {0, 3, 4},
                      {0, 4, 5},
                      {0, 5, 1},
                      {1, 2, 4},
                      {2, 3, 5},
                      {3, 4, 1},
                      {4, 5, 2},
                      {5, 1, 3}}};
  const MeshGaps gaps = orient_outwards(plane);
  EXPECT_EQ(gaps.open_edges, 0u);
  EXPECT_TRUE(gaps.is_one_sided);
}

TEST(OrientOutwards, AHollowInASolidIsACavityAndASolidInItIsSolid) {
  TriangleMesh mesh = box_mesh({{-3, -3, -3}, {3, 3, 3}, {}, 0});
  append(mesh, box_mesh({{-2, -2, -2}, {2, 2, 2}, {}, 0}));
  append(mesh, box_mesh({{-1, -1, -1}, {1, 1, 1}, {}, 0}));
  append(mesh, box_mesh({{7, 0, 0}, {8, 1, 1}, {}, 0}));
  EXPECT_TRUE(orient_outwards(mesh).is_watertight());
  EXPECT_NEAR(volume(mesh), 216 - 64 + 8 + 1, 1e-12);
  EXPECT_NEAR(winding_number(mesh, {0, 0, 2.5}), 1, 1e-12);
  EXPECT_NEAR(winding_number(mesh, {0, 0, 1.5}), 0, 1e-12);
  EXPECT_NEAR(winding_number(mesh, {0, 0, 0.5}), 1, 1e-12);
}

}  // namespace
}  // namespace sabo
