#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "rasters.hpp"
#include "support/folders.hpp"
#include "support/ground.hpp"
#include <gtest/gtest.h>

#include "terrain/ground.hpp"
#include "terrain/inset_height.hpp"

// Ground particles fill everything within the kernel radius of the surface, also where it is
// broken.

namespace sabo {
namespace {

constexpr int layers = 3;

struct Window {
  double x, y, half;  ///< a square in plan, m

  bool holds(const Vec3d& p) const { return std::abs(p.x - x) < half && std::abs(p.y - y) < half; }
};

struct Place {
  std::string name;
  Surface surface;
  Window window;
};

Place step() {
  return {"step",
          Surface(raster_of(square_grid(-15, 15, 1),
                            [](double x, double) { return x > 0 ? 5.0 : 0.0; })),
          {0, 0, 4}};
}

Place diagonal_step() {
  return {"diagonal step",
          Surface(raster_of(square_grid(-15, 15, 1),
                            [](double x, double y) { return x + y > 0.5 ? 5.0 : 0.0; })),
          {0, 0, 4}};
}

Place steep_plane() {
  return {"steep plane",
          Surface(raster_of(square_grid(-15, 15, 1),
                            [](double x, double y) {
                              return 4.5 * x + 3 * y;  // 79.5 degrees
                            })),
          {0, 0, 3}};
}

Place plane() {
  return {"plane",
          Surface(raster_of(square_grid(-15, 15, 1), [](double x, double) { return x; })),
          {0, 0, 4}};
}

/// Every cell at random: slopes up to 80 degrees, spikes of one cell.
Place noise() {
  Random random;
  return {"noise",
          Surface(raster_of(square_grid(-15, 15, 1), [&](double, double) { return 5 * random(); })),
          {0, 0, 6}};
}

Particles ground_of(const Place& place, double spacing) {
  Ground ground(place.surface, {}, {spacing, layers, 1000});
  Particles particles;
  const auto& [x, y, half] = place.window;
  const double around = half + 4 * spacing;
  ground.make_all(x - around, y - around, x + around, y + around, particles);
  return particles;
}

double gap(const std::vector<Vec3d>& positions, const Vec3d& point) {
  double least = 1e9;
  for (const Vec3d& p : positions) least = std::min(least, norm(p - point));
  return least;
}

struct Gaps {
  double widest = 0;  ///< spacings
  int points = 0;
  int wide = 0;  ///< points with a gap above one spacing
};

/// Gaps at points half a spacing, 1.5 and 2.5 spacings below random points of the surface, those
/// left out that lie much nearer to another face.
Gaps gaps_in(const Place& place, double spacing) {
  const Particles particles = ground_of(place, spacing);
  const auto& [x, y, half] = place.window;
  Random random;
  Gaps gaps;
  for (int trial = 0; trial < 600; ++trial) {
    const double u = x + half * (2 * random() - 1);
    const double v = y + half * (2 * random() - 1);
    for (int layer = 0; layer < layers; ++layer) {
      const double depth = (layer + 0.5) * spacing;
      const Vec3d point =
          Vec3d{u, v, place.surface.height(u, v)} - depth * place.surface.normal(u, v);
      if (test::distance_to(place.surface, point, depth) > -0.4 * depth) continue;
      const double width = gap(particles.position, point) / spacing;
      gaps.widest = std::max(gaps.widest, width);
      gaps.wide += width > 1;
      ++gaps.points;
    }
  }
  return gaps;
}

/// Volume of the shell `layers` spacings thick, in a window.
double shell_volume(const Place& place, double spacing) {
  constexpr int cells = 80;
  const auto& [x, y, half] = place.window;
  const double cell = 2 * half / cells;
  double volume = 0;
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      const double u = x - half + (i + 0.5) * cell;
      const double v = y - half + (j + 0.5) * cell;
      const double bottom = inset_height(place.surface, u, v, layers * spacing);
      volume += cell * cell * (place.surface.height(u, v) - bottom);
    }
  }
  return volume;
}

class GroundShell : public testing::TestWithParam<double> {};

TEST_P(GroundShell, HasNoGap) {
  for (const Place& place : {plane(), step(), steep_plane(), diagonal_step()}) {
    const Gaps gaps = gaps_in(place, GetParam());
    EXPECT_LT(gaps.widest, place.name == "diagonal step" ? 1.1 : 1.0) << place.name;
    EXPECT_GT(gaps.points, 500) << place.name;
  }
}

TEST_P(GroundShell, HasFewGapsInNoise) {
  const Gaps gaps = gaps_in(noise(), GetParam());
  EXPECT_LT(gaps.widest, 1.5);
  EXPECT_LT(gaps.wide, 0.02 * gaps.points);
}

TEST_P(GroundShell, HasTheMassOfItsVolume) {
  const double spacing = GetParam();
  for (const Place& place : {plane(), step(), steep_plane(), diagonal_step(), noise()}) {
    const Particles particles = ground_of(place, spacing);
    double mass = 0;
    for (std::size_t k = 0; k < particles.size(); ++k) {
      if (place.window.holds(particles.position[k])) mass += particles.mass[k];
    }
    EXPECT_NEAR(mass / (1000 * shell_volume(place, spacing)), 1, 0.15) << place.name;
  }
}

TEST_P(GroundShell, NeitherTouchesTheSurfaceNorCrowds) {
  const double spacing = GetParam();
  for (const Place& place : {step(), steep_plane(), diagonal_step()}) {
    const Particles particles = ground_of(place, spacing);
    for (std::size_t k = 0; k < particles.size(); ++k) {
      const Vec3d& p = particles.position[k];
      if (!place.window.holds(p)) continue;
      EXPECT_LE(test::distance_to(place.surface, p, spacing), -0.3 * spacing) << place.name;
      EXPECT_LT(particles.mass[k], 1.25 * 1000 * spacing * spacing * spacing) << place.name;
      for (std::size_t other = 0; other < k; ++other) {
        EXPECT_GT(norm(particles.position[other] - p), 0.3 * spacing) << place.name;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Spacings, GroundShell, testing::Values(1.0, 0.5));

TEST(GroundShellOfARealSlope, HasNoGap) {
  std::ifstream file(data_folder() / "terrain" / "dangchuan7_1m" / "dc7_dem_1411slide.txt");
  if (!file) GTEST_SKIP() << "no data: set SABO_DATA";
  std::string key;
  Grid grid;
  double cell = 0;
  double no_data = 0;
  double corner = 0;
  file >> key >> grid.columns >> key >> grid.rows >> key >> corner >> key >> corner >> key >>
      cell >> key >> no_data;
  grid = {grid.columns, grid.rows, 0, grid.rows * cell, cell, cell};
  Raster raster(grid);
  for (double& value : raster.values) {
    file >> value;
    if (value == no_data) value = Raster::no_data;
  }
  const Surface surface(raster);
  for (const Window& window : {Window{190, 140, 6}, Window{171, 205, 6}, Window{142, 195, 6}}) {
    EXPECT_LT(gaps_in({"Dangchuan", surface, window}, 1).widest, 1) << window.x;
  }
}

TEST(InsetHeight, OfAPlaneLiesStraightBelow) {
  const Surface surface = plane().surface;
  EXPECT_NEAR(inset_height(surface, 0.3, 0.2, 2), 0.3 - 2 * std::sqrt(2), 1e-12);
}

TEST(InsetHeight, BehindAWallIsTheWallMovedBack) {
  const Surface surface = step().surface;  // rises from (0, 0) to (1, 5)
  EXPECT_NEAR(inset_height(surface, -3, 0, 2), -2, 1e-12);
  EXPECT_NEAR(inset_height(surface, 4, 0, 2), 3, 1e-12);
  EXPECT_NEAR(inset_height(surface, 0.9, 0, 0.5), 4.5 - 0.5 * std::sqrt(26), 1e-12);
  EXPECT_NEAR(inset_height(surface, 0.8, 0, 1), -0.6, 1e-12);  // touches the foot of the wall
}

TEST(InsetHeight, IsAsFarFromTheSurfaceAsAsked) {
  const Surface surface = noise().surface;
  Random random;
  for (int trial = 0; trial < 500; ++trial) {
    const double x = 16 * random() - 8;
    const double y = 16 * random() - 8;
    const double depth = 0.2 + 4 * random();
    const Vec3d point{x, y, inset_height(surface, x, y, depth)};
    EXPECT_NEAR(test::distance_to(surface, point, 5), -depth, 1e-9)
        << x << ' ' << y << ' ' << depth;
  }
}

}  // namespace
}  // namespace sabo
