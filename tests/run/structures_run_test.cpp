#include <cmath>
#include <string>
#include <vector>

#include "support/temporary_folder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/case_file/read_case.hpp"
#include "run/flow.hpp"

// Water 0.5 m deep in a tank of 1.2 m between its back and a dam of 0.4 m, particles of 0.1 m.

namespace sabo {
namespace {

constexpr double pool_depth = 0.5, dam_middle = 1.4;  // m

/// Openings as tables after that of the dam.
std::string dam_with(const std::string& openings) {
  return "[[structure]]\nname = \"dam\"\nline = [[1.4, 0], [1.4, 1.2]]\nheight = 1\n"
         "thickness = 0.4\n" +
         openings;
}

const std::string slit = "[[structure.slit]]\ncentre = 0.6\nwidth = 0.4\n";
/// Two gaps of 0.4 m beside a post of 0.2 m.
const std::string grid = "[[structure.grid]]\nfrom = 0\nto = 1.2\ngap = 0.4\npost_width = 0.2\n";

/// The water at some times (s), in the coordinates of the case.
std::vector<Particles> water_at(const std::vector<double>& times, const std::string& structures,
                                const char* backend) {
  const TemporaryFolder folder;
  Faults faults;
  const Case c = read_case_text(
      "[terrain.plane]\nextent = [-0.5, -0.5, 3.5, 1.7]\n[release]\nbox = [0, 0, 0, 1.2, 1.2, "
      "0.5]\n"
      "[[body]]\nname = \"tank\"\nkind = \"tank\"\nmin = [0, 0, 0]\nmax = [3, 1.2, 1]\n"
      "[material]\ndensity = 1000\nrheology = \"newtonian\"\nviscosity = 0.01\n"
      "[numerics]\nspacing = 0.1\nthreads = 1\nbackend = \"" +
          std::string(backend) + "\"\n[run]\nduration = 1\n" + structures,
      folder / "", faults);
  const Scene scene = make_scene(c, faults);
  for (const Fault& fault : faults.list()) ADD_FAILURE() << to_string(fault);
  std::vector<Particles> states(times.size());
  if (!faults.empty()) return states;
  Flow flow(c, scene);
  for (std::size_t k = 0; k < times.size(); ++k) {
    flow.stepper().advance_to(times[k]);
    states[k] = flow.backend().fluid();
    for (Vec3d& x : states[k].position) x += Vec3d{scene.frame.origin_x, scene.frame.origin_y, 0};
  }
  return states;
}

/// Volume beyond the middle of the dam, m3.
double passed(const Particles& water) {
  double mass = 0;
  for (std::size_t i = 0; i < water.size(); ++i)
    if (water.position[i].x > dam_middle) mass += water.mass[i];
  return mass / 1000;
}

/// What flows through openings between two times once it flows freely, over the critical flow
/// Q = (2/3)^1.5 sqrt(g) b H^1.5 through their whole width b at the mean depth H of the pool.
double discharge_coefficient(const std::string& openings, double width) {
  constexpr double first = 0.3, last = 0.7;  // s
  const std::vector<Particles> states = water_at({first, last}, dam_with(openings), "cpu");
  const double before = passed(states[0]), after = passed(states[1]);
  const double depth = pool_depth - (before + after) / 2 / (dam_middle * 1.2);
  const double critical = std::pow(2.0 / 3, 1.5) * std::sqrt(9.81) * width * std::pow(depth, 1.5);
  return (after - before) / (last - first) / critical;
}

TEST(StructuresRun, AClosedDamHoldsTheWater) {
  EXPECT_EQ(passed(water_at({0.7}, dam_with(""), "cpu").back()), 0);
}

TEST(StructuresRun, OpeningsLetThroughWhatTheirWidthLetsThrough) {
  const double of_slit = discharge_coefficient(slit, 0.4);
  const double of_grid = discharge_coefficient(grid, 0.8);
  // Critical flow is the most that a width lets through; contraction and friction take off up to
  // four tenths, as at the sharpest orifice.
  for (const double coefficient : {of_slit, of_grid}) {
    EXPECT_GT(coefficient, 0.6);
    EXPECT_LT(coefficient, 1);
  }
}

TEST(StructuresRun, TheReferenceBackendLetsThroughAsMuch) {
  const double cpu = passed(water_at({0.3}, dam_with(slit), "cpu").back());
  EXPECT_GT(cpu, 0.01);
  EXPECT_NEAR(passed(water_at({0.3}, dam_with(slit), "reference").back()), cpu, 0.003);
}

TEST(StructuresRun, AHouseStaysDryInside) {
  // Across half of the way, and one of six corners.
  const std::vector<Particles> states = water_at(
      {0.8},
      "[[structure]]\nkind = \"building\"\nheight = 2\npolygon = [[1.5, 0.4], [2.1, 0.4], "
      "[2.1, 1.0], [1.5, 1.0]]\n"
      "[[structure]]\nkind = \"building\"\nheight = 2\npolygon = [[2.4, 0], [2.8, 0], [2.8, 0.8], "
      "[2.6, 0.8], [2.6, 0.4], [2.4, 0.4]]\n",
      "cpu");
  double farthest = 0;
  for (const Vec3d& x : states.back().position) {
    farthest = std::max(farthest, x.x);
    const bool is_in_first = x.x > 1.51 && x.x < 2.09 && x.y > 0.41 && x.y < 0.99;
    const bool is_in_second = x.x > 2.61 && x.x < 2.79 && x.y < 0.79;
    EXPECT_FALSE(is_in_first || is_in_second) << x.x << ' ' << x.y << ' ' << x.z;
  }
  EXPECT_GT(farthest, 2.5);  // it has come as far as both
}

}  // namespace
}  // namespace sabo
