#include "analysis/flow_surface.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sabo {
namespace {

using testing::Each;
using testing::ElementsAre;

/// 5 x 4 cells of 2 m, 10 m high in the west and 1 m lower in each column to the east.
Raster slope() {
  Raster ground(Grid{.columns = 5, .rows = 4, .west = 0, .north = 8, .dx = 2, .dy = 2});
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 5; ++column) ground.at(column, row) = 10 - column;
  return ground;
}

/// Particles of 2 m, 8 m3 each, at the centres of cells: each stands on its own cell, 2 m deep.
Columns columns_with(const Raster& ground, const std::vector<Vec3d>& places, double speed) {
  Particles particles;
  particles.resize(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    particles.position[i] = places[i];
    particles.velocity[i] = {speed, 0, 0};
    particles.mass[i] = 8000;
  }
  Columns columns(ground, 1, 1000);
  columns.update(particles);
  return columns;
}

TEST(FlowSurface, OneWetCellIsTheTopOfItsTriangles) {
  const Raster ground = slope();
  // Of the cell in column 1, row 1: six triangles meet at a corner that is cut this way.
  const FlowSurface surface = flow_surface(columns_with(ground, {{3, 5, 10}}, 4), ground);
  EXPECT_EQ(surface.mesh.triangles.size(), 6u);
  ASSERT_EQ(surface.mesh.vertices.size(), 7u);
  EXPECT_DOUBLE_EQ(surface.mesh.vertices[3].z, 9 + 2);  // the wet one: in rows 2, 3, 2
  EXPECT_THAT(surface.depth, ElementsAre(0, 0, 0, 2, 0, 0, 0));
  EXPECT_THAT(surface.speed, ElementsAre(0, 0, 0, 4, 0, 0, 0));
  EXPECT_THAT(surface.ground, ElementsAre(10, 9, 10, 9, 8, 9, 8));
}

TEST(FlowSurface, TrianglesLookUp) {
  const Raster ground = slope();
  const FlowSurface surface =
      flow_surface(columns_with(ground, {{3, 5, 10}, {5, 5, 9}, {5, 3, 9}}, 1), ground);
  for (std::size_t t = 0; t < surface.mesh.triangles.size(); ++t)
    EXPECT_GT(area_vector(surface.mesh, t).z, 0);
}

TEST(FlowSurface, CellsWithoutGroundHaveNone) {
  Raster ground = slope();
  ground.at(2, 1) = Raster::no_data;
  const FlowSurface surface = flow_surface(columns_with(ground, {{3, 5, 10}}, 4), ground);
  EXPECT_EQ(surface.mesh.triangles.size(), 4u);  // two of the six had that corner
  EXPECT_THAT(surface.ground, Each(testing::Ge(8)));
}

TEST(FlowSurface, NoFlowIsAnEmptyMesh) {
  const Raster ground = slope();
  const FlowSurface surface = flow_surface(columns_with(ground, {}, 0), ground);
  EXPECT_TRUE(surface.mesh.triangles.empty());
  EXPECT_TRUE(surface.mesh.vertices.empty());
}

}  // namespace
}  // namespace sabo
