#include <cmath>
#include <string>

#include "support/temporary_folder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/case_file/read_case.hpp"
#include "run/flow.hpp"

// Water 0.5 m deep in a tank of 1.2 m between its back and a dam of 0.4 m, particles of 0.1 m.

namespace sabo {
namespace {

constexpr double pool_length = 1.2, pool_depth = 0.5, dam_middle = 1.4;  // m

/// Openings as tables after that of the dam.
std::string dam_with(const std::string& openings) {
  return "[[structure]]\nname = \"dam\"\nline = [[1.4, 0], [1.4, 1.2]]\nheight = 1\n"
         "thickness = 0.4\n" +
         openings;
}

const std::string slit = "[[structure.slit]]\ncentre = 0.6\nwidth = 0.4\n";
/// Two gaps of 0.4 m beside a post of 0.2 m.
const std::string grid = "[[structure.grid]]\nfrom = 0\nto = 1.2\ngap = 0.4\npost_width = 0.2\n";

/// The water after some time (s).
Particles water_after(double time, const std::string& structures, const char* backend) {
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
  if (!faults.empty()) return {};
  Flow flow(c, scene);
  flow.stepper().advance_to(time);
  flow.domain().update(flow.backend().fluid(), flow.backend().boundary(), 0.3);
  return flow.backend().fluid();
}

/// Volume beyond the middle of the dam, m3.
double passed(const Particles& water) {
  double mass = 0;
  for (std::size_t i = 0; i < water.size(); ++i)
    if (water.position[i].x > dam_middle) mass += water.mass[i];
  return mass / 1000;
}

/// By critical flow through a width b: Q = (2/3)^1.5 sqrt(g) b H^1.5 out of a pool that sinks,
/// whose depth is H = H0/(1 + k t)^2 then.
double ideal_passed(double width, double time) {
  const double rate = std::pow(2.0 / 3, 1.5) * std::sqrt(9.81) * width / (pool_length * 1.2);
  const double depth = pool_depth / std::pow(1 + rate * std::sqrt(pool_depth) / 2 * time, 2);
  return pool_length * 1.2 * (pool_depth - depth);
}

TEST(StructuresRun, ADamHoldsWhatASlitLetsThroughAndAGridLetsThroughMore) {
  EXPECT_EQ(passed(water_after(0.8, dam_with(""), "cpu")), 0);
  const double by_slit = passed(water_after(0.8, dam_with(slit), "cpu"));
  const double by_grid = passed(water_after(0.8, dam_with(grid), "cpu"));
  EXPECT_NEAR(by_slit / ideal_passed(0.4, 0.8), 1, 0.3);
  EXPECT_NEAR(by_grid / ideal_passed(0.8, 0.8), 1, 0.3);
  EXPECT_GT(by_grid, 1.5 * by_slit);
}

TEST(StructuresRun, TheReferenceBackendLetsThroughAsMuch) {
  const double cpu = passed(water_after(0.3, dam_with(slit), "cpu"));
  EXPECT_GT(cpu, 0.01);
  EXPECT_NEAR(passed(water_after(0.3, dam_with(slit), "reference")), cpu, 0.003);
  EXPECT_EQ(passed(water_after(0.2, dam_with(""), "reference")), 0);
}

TEST(StructuresRun, AHouseStaysDryInside) {
  // Across half of the way, and one of six corners.
  const Particles water = water_after(
      0.8,
      "[[structure]]\nkind = \"building\"\nheight = 2\npolygon = [[1.5, 0.4], [2.1, 0.4], "
      "[2.1, 1.0], [1.5, 1.0]]\n"
      "[[structure]]\nkind = \"building\"\nheight = 2\npolygon = [[2.4, 0], [2.8, 0], [2.8, 0.8], "
      "[2.6, 0.8], [2.6, 0.4], [2.4, 0.4]]\n",
      "cpu");
  double farthest = 0;
  for (const Vec3d& x : water.position) {
    farthest = std::max(farthest, x.x);
    const bool is_in_first = x.x > 1.51 && x.x < 2.09 && x.y > 0.41 && x.y < 0.99;
    const bool is_in_second = x.x > 2.61 && x.x < 2.79 && x.y < 0.79;
    EXPECT_FALSE(is_in_first || is_in_second) << x.x << ' ' << x.y << ' ' << x.z;
  }
  EXPECT_GT(farthest, 2.5);  // it has come as far as both
}

}  // namespace
}  // namespace sabo
