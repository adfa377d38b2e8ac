#include "terrain/surface.hpp"

#include <cmath>
#include <limits>

#include "geometry/nearest_on_triangle.hpp"
#include "rasters.hpp"
#include "support/ground.hpp"
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "base/error.hpp"

namespace sabo {
namespace {

Surface rising() {  // rises by 0.75 to the east and falls by 0.5 to the north
  return Surface(
      raster_of({12, 8, 100, 200, 2, 1}, [](double x, double y) { return 0.75 * x - 0.5 * y; }));
}

TEST(Surface, PlaneIsExact) {
  const Surface surface = rising();
  EXPECT_NEAR(surface.height(107.3, 195.8), 0.75 * 107.3 - 0.5 * 195.8, 1e-12);
  const Vec3d expected = normalised(Vec3d{-0.75, 0.5, 1});
  const Vec3d normal = surface.normal(107.3, 195.8);
  EXPECT_NEAR(norm(normal - expected), 0, 1e-12);
  const Vec3d foot{107.3, 195.8, surface.height(107.3, 195.8)};
  EXPECT_NEAR(test::distance_to(surface, foot + 0.6 * expected, 5), 0.6, 1e-12);
  EXPECT_NEAR(test::distance_to(surface, foot - 0.6 * expected, 5), -0.6, 1e-12);
}

TEST(Surface, DiagonalRunsFromNorthWestToSouthEast) {
  Raster raster({2, 2, 0, 2, 1, 1}, 0);
  raster.at(1, 0) = 1;  // north-east corner, at (1.5, 1.5)
  const Surface surface(raster);
  EXPECT_DOUBLE_EQ(surface.height(1.0, 1.0), 0);    // on the diagonal
  EXPECT_DOUBLE_EQ(surface.height(0.75, 0.75), 0);  // south-west triangle
  EXPECT_DOUBLE_EQ(surface.height(1.25, 1.25), 0.5);
  EXPECT_EQ(surface.normal(0.75, 0.75), (Vec3d{0, 0, 1}));
  EXPECT_NEAR(surface.normal(1.25, 1.25).x, -1 / std::sqrt(3), 1e-12);
  EXPECT_NEAR(surface.normal(1.25, 1.25).y, -1 / std::sqrt(3), 1e-12);
}

TEST(Surface, ParaboloidToSecondOrder) {
  const Surface surface(
      raster_of(square_grid(-5, 5, 0.1), [](double x, double y) { return 0.1 * (x * x + y * y); }));
  EXPECT_NEAR(surface.height(2.03, -1.17), 0.1 * (2.03 * 2.03 + 1.17 * 1.17), 0.001);
  // From the focus, 1 / (4 * 0.1) above the vertex, the vertex is nearest.
  EXPECT_NEAR(test::distance_to(surface, {0, 0, 2.5}, 4), 2.5, 0.001);
}

TEST(Surface, DomainEndsAtTheLastCellCentres) {
  const Surface surface = rising();
  EXPECT_TRUE(surface.inside(101, 199.5));
  EXPECT_FALSE(surface.inside(100.9, 199.5));
  EXPECT_TRUE(surface.inside(123, 192.5));
  EXPECT_FALSE(surface.inside(123, 192.4));
  EXPECT_FALSE(surface.inside(std::nan(""), 195));
}

TEST(Surface, CellsWithoutDataTakeTheirTrianglesOut) {
  Raster raster(square_grid(0, 4, 1), 7);
  raster.at(2, 2) = Raster::no_data;  // at (2, 2)
  raster.at(0, 0) = std::numeric_limits<double>::infinity();
  const Surface surface(raster);
  EXPECT_FALSE(surface.inside(2, 2));
  EXPECT_FALSE(surface.inside(2.4, 1.8));
  EXPECT_FALSE(surface.inside(0, 4));
  EXPECT_TRUE(surface.inside(3.5, 3.5));
  // South-west of the cell is one of the two triangles of a square that do not touch it.
  EXPECT_TRUE(surface.inside(1.2, 1.2));
  EXPECT_DOUBLE_EQ(surface.height(2, 2), 7);
  EXPECT_DOUBLE_EQ(surface.height(-100, 300), 7);
}

TEST(Surface, RefusesWhatHasNoGround) {
  EXPECT_THROW(Surface(Raster({1, 5, 0, 0, 1, 1})), CaseError);
  EXPECT_THROW(Surface(Raster({3, 3, 0, 0, 1, 1}, Raster::no_data)), CaseError);
}

Surface rough() {
  Random random;
  return Surface(raster_of(square_grid(-6, 6, 1), [&](double, double) { return 3 * random(); }));
}

TEST(Surface, DistanceIsTheLeastOverAllTriangles) {
  const Surface surface = rough();
  const Raster& z = surface.elevation();
  rc::check([&] {
    const auto coordinate = [](int low, int high) {
      return *rc::gen::inRange(low * 1000, high * 1000) / 1000.0;
    };
    const Vec3d point{coordinate(-6, 6), coordinate(-6, 6), coordinate(-3, 6)};
    double least = std::numeric_limits<double>::infinity();
    for (int row = 0; row + 1 < z.grid.rows; ++row) {
      for (int column = 0; column + 1 < z.grid.columns; ++column) {
        const auto vertex = [&](int c, int r) {
          return Vec3d{z.grid.x_of(c), z.grid.y_of(r), z.at(c, r)};
        };
        for (const Vec3d& third : {vertex(column + 1, row), vertex(column, row + 1)}) {
          const Vec3d foot =
              nearest_on_triangle(point, vertex(column, row), third, vertex(column + 1, row + 1));
          least = std::min(least, norm(point - foot));
        }
      }
    }
    const double reach = 2.5;
    const double distance = test::distance_to(surface, point, reach);
    RC_ASSERT(std::abs(std::abs(distance) - std::min(least, reach)) < 1e-12);
    const double above = point.z - surface.height(point.x, point.y);
    RC_ASSERT(above == 0 || (distance > 0) == (above > 0));
  });
}

}  // namespace
}  // namespace sabo
