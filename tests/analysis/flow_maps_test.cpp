#include "analysis/flow_maps.hpp"

#include <cmath>
#include <limits>
#include <map>

#include "cloud.hpp"
#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace sabo {
namespace {

constexpr double nan = Raster::no_data;

/// 5 columns by 4 rows of cells 2 m x 2 m; west 10, north 20, so south 12 and east 20.
Raster ground() { return Raster({5, 4, 10, 20, 2, 2}, 0); }

std::map<std::size_t, double> shares(const Spreader& spreader, double x, double y) {
  std::map<std::size_t, double> found;
  spreader.spread(x, y, [&](std::size_t cell, double share) { found[cell] += share; });
  return found;
}

double sum(const Raster& map) {
  double total = 0;
  for (const double value : map.values) total += std::isnan(value) ? 0 : value;
  return total;
}

TEST(WetDepth, FollowsTheSpacingOfTheLaboratory) {
  EXPECT_EQ(wet_depth(1), 0.05);
  EXPECT_EQ(wet_depth(0.02), 0.01);
  // Layers 2 cm deep on cells of 10 cm, of particles of 2 cm.
  Columns columns(Raster({2, 1, 0, 0.1, 0.1, 0.1}, 0), 0.02, 1000);
  Particles one = cloud({{0.05, 0.05, 0.01}});
  one.mass[0] = 1000 * 0.02 * 0.1 * 0.1;
  columns.update(one);
  EXPECT_TRUE(columns.is_wet(0));
  EXPECT_FALSE(columns.is_wet(1));
}

// Spacing 0.5: the square is one cell, 2 m. Its centre is 0.5 m east and 0.5 m south of the centre
// (13, 17) of cell (1, 1): three quarters by three quarters stay there.
TEST(Spreader, shares_are_areas_of_overlap) {
  const Grid grid = ground().grid;
  const std::map<std::size_t, double> expected{{grid.index(1, 1), 0.5625},
                                               {grid.index(2, 1), 0.1875},
                                               {grid.index(1, 2), 0.1875},
                                               {grid.index(2, 2), 0.0625}};
  EXPECT_EQ(shares(Spreader(ground(), 0.5), 13.5, 16.5), expected);
}

// Spacing 2: the square is 4 m wide. About the centre of a cell it covers that cell, half of each
// neighbour and a quarter of each diagonal one: 1, 1/2, 1/4 of 4 m2 each in 16 m2.
TEST(Spreader, footprint_is_two_spacings_wide) {
  const auto found = shares(Spreader(ground(), 2), 13, 17);
  const Grid grid = ground().grid;
  EXPECT_EQ(found.size(), 9u);
  EXPECT_DOUBLE_EQ(found.at(grid.index(1, 1)), 0.25);
  EXPECT_DOUBLE_EQ(found.at(grid.index(0, 1)), 0.125);
  EXPECT_DOUBLE_EQ(found.at(grid.index(2, 2)), 0.0625);
}

TEST(Spreader, cells_may_be_oblong) {
  const Raster oblong({4, 4, 0, 4, 4, 1}, 0);  // 4 m wide, 1 m high
  const auto found = shares(Spreader(oblong, 1), 6, 2.5);
  EXPECT_EQ(found.size(), 3u);  // 4 m wide: one column; 2 m high: half, one, half
  EXPECT_DOUBLE_EQ(found.at(oblong.grid.index(1, 0)), 0.25);
  EXPECT_DOUBLE_EQ(found.at(oblong.grid.index(1, 1)), 0.5);
  EXPECT_DOUBLE_EQ(found.at(oblong.grid.index(1, 2)), 0.25);
}

TEST(Spreader, holes_hand_their_part_to_the_other_cells) {
  Raster holed = ground();
  holed.at(2, 1) = nan;
  const auto found = shares(Spreader(holed, 0.5), 14, 17);  // half in (1, 1), half in the hole
  EXPECT_EQ(found, (std::map<std::size_t, double>{{holed.grid.index(1, 1), 1.0}}));
}

TEST(Spreader, outside_everything_the_nearest_cell_takes_all) {
  Raster corner = ground();
  for (double& value : corner.values) value = nan;
  corner.at(4, 3) = 0;
  corner.at(0, 3) = 0;
  const Grid& grid = corner.grid;
  const Spreader spreader(corner, 0.5);
  const auto only = [](std::size_t cell) { return std::map<std::size_t, double>{{cell, 1.0}}; };
  EXPECT_EQ(shares(spreader, 11, 19), only(grid.index(0, 3)));
  EXPECT_EQ(shares(spreader, 1e9, 19), only(grid.index(4, 3)));
  EXPECT_EQ(shares(spreader, -1e300, -1e300), only(grid.index(0, 3)));
  EXPECT_EQ(shares(spreader, nan, std::numeric_limits<double>::infinity()), only(grid.index(0, 3)));
}

TEST(Spreader, nearest_is_by_distance_not_by_ring) {
  Raster cells({9, 9, 0, 9, 1, 1}, nan);
  cells.at(7, 1) = 0;  // ring 3 about (4, 4), on its diagonal: 4.24 m
  cells.at(4, 8) = 0;  // ring 4, straight: 4 m
  EXPECT_EQ(shares(Spreader(cells, 0.1), 4.5, 4.5).begin()->first, cells.grid.index(4, 8));
}

TEST(Spreader, without_a_domain_nothing_is_spread) {
  EXPECT_TRUE(shares(Spreader(Raster({3, 3, 0, 3, 1, 1}, nan), 1), 1, 1).empty());
}

TEST(FlowMaps, volume_is_exact_for_any_cloud_edges_and_holes) {
  EXPECT_TRUE(rc::check("sum of depth x area = sum of mass / density", [] {
    const auto metres = [](int low, int high) { return *rc::gen::inRange(low, high) / 16.0; };
    Raster elevation({*rc::gen::inRange(1, 12), *rc::gen::inRange(1, 12), metres(-80, 80),
                      metres(-80, 80), metres(1, 64), metres(1, 64)});
    for (double& value : elevation.values) value = *rc::gen::inRange(0, 3) == 0 ? nan : 100;
    elevation.values[*rc::gen::inRange<std::size_t>(0, elevation.values.size())] = 100;

    std::vector<Vec3d> points(*rc::gen::inRange<std::size_t>(1, 40));
    for (Vec3d& point : points) point = {metres(-400, 400), metres(-400, 400), 0};
    Particles particles = cloud(points);
    double volume = 0;
    for (double& mass : particles.mass) volume += (mass = metres(1, 1000)) / 1726;

    FlowMaps maps(elevation, metres(1, 160), 1726);
    maps.update(0, cloud({{0, 0, 0}}));  // nothing of the update before may remain
    maps.update(1, particles);
    const double found = sum(maps.depth()) * elevation.grid.cell_area();
    RC_ASSERT(std::abs(found - volume) <= 1e-12 * volume);
  }));
}

// One particle of 1.6 m3 = 0.4 m on one cell goes from cell (0, 0) to cell (2, 1).
TEST(FlowMaps, peaks_arrival_and_final_depth_of_a_moving_particle) {
  Raster elevation = ground();
  elevation.at(4, 3) = nan;
  FlowMaps maps(elevation, 0.5, 1000);
  Particles particle = cloud({{11, 19, 5}}, 1600);
  particle.velocity[0] = {3, 0, 4};
  maps.update(1, particle);
  particle.position[0] = {15, 17, 5};
  particle.velocity[0] = {0, 2, 0};
  maps.update(2, particle);

  EXPECT_DOUBLE_EQ(maps.peak_depth().at(0, 0), 0.4);
  EXPECT_DOUBLE_EQ(maps.peak_momentum_flux().at(0, 0), 1000 * 0.4 * 25);
  EXPECT_DOUBLE_EQ(maps.peak_momentum_flux().at(2, 1), 1000 * 0.4 * 4);
  EXPECT_DOUBLE_EQ(maps.peak_depth().at(2, 1), 0.4);
  EXPECT_EQ(maps.peak_depth().at(1, 1), 0);
  EXPECT_DOUBLE_EQ(maps.peak_speed().at(0, 0), 5);
  EXPECT_DOUBLE_EQ(maps.peak_speed().at(2, 1), 2);
  EXPECT_EQ(maps.arrival_time().at(0, 0), 1);
  EXPECT_EQ(maps.arrival_time().at(2, 1), 2);
  EXPECT_TRUE(std::isnan(maps.arrival_time().at(1, 1)));
  EXPECT_EQ(maps.depth().at(0, 0), 0);
  EXPECT_DOUBLE_EQ(maps.depth().at(2, 1), 0.4);
  for (const Raster& map : {maps.peak_depth(), maps.peak_speed(), maps.depth()}) {
    EXPECT_TRUE(std::isnan(map.at(4, 3)));
  }

  maps.update(3, particle);
  EXPECT_EQ(maps.arrival_time().at(2, 1), 2) << "arrival is the first time";
}

TEST(FlowMaps, films_have_depth_but_neither_speed_nor_arrival) {
  FlowMaps maps(ground(), 0.5, 1000);
  Particles film = cloud({{11, 19, 0}}, 196);  // 0.049 m on 4 m2
  film.velocity[0] = {9, 0, 0};
  maps.update(1, film);
  EXPECT_DOUBLE_EQ(maps.peak_depth().at(0, 0), 0.049);
  EXPECT_EQ(maps.peak_speed().at(0, 0), 0);
  EXPECT_TRUE(std::isnan(maps.arrival_time().at(0, 0)));
}

TEST(FlowMaps, speed_is_the_mean_by_mass) {
  FlowMaps maps(ground(), 0.5, 1000);
  Particles two = cloud({{11, 19, 0}, {11, 19, 1}}, 300);
  two.mass[1] = 900;
  two.velocity[0] = {8, 0, 0};
  maps.update(0, two);
  EXPECT_DOUBLE_EQ(maps.peak_speed().at(0, 0), 2);  // 300 x 8 / 1200
}

}  // namespace
}  // namespace sabo
