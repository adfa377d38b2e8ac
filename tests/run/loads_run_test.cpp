// Water at rest before a wall in a tank: what the wall bears is known. The wall comes first, so
// that where it meets the sides of the tank what lies behind its face is its own.

#include <map>
#include <sstream>
#include <vector>

#include "support/temporary_folder.hpp"
#include <gtest/gtest.h>

#include "run/finished_run.hpp"

namespace sabo {
namespace {

constexpr double depth = 0.5, width = 0.4, spacing = 0.05;  // m
constexpr double density = 1000, g = 9.81;                  // kg/m3, m/s2

const char* const still_water = R"(
[terrain.plane]
extent = [-1, -1, 2, 1]
[[body]]
name = "wall"
kind = "box"
min = [0.6, -0.35, 0]
max = [1.1, 0.35, 0.8]
[[body]]
name = "tank"
kind = "tank"
min = [0, -0.2, 0]
max = [1.2, 0.2, 0.8]
[release]
box = [0, -0.2, 0, 0.6, 0.2, 0.5]
[material]
density = 1000
rheology = "newtonian"
viscosity = 0.1
[loads]
filter = 0.1
[[gauge]]
name = "middle"
place = [0.3, 0]
[[gauge]]
name = "halfway up"
place = [0.3, 0]
elevation = 0.25
[[section]]
name = "across"
line = [[0.3, -0.2], [0.3, 0.2]]
[numerics]
spacing = 0.05
h_max = 0.5
[run]
duration = 1
series_interval = 0.25
stop_at_rest = false
)";

/// Pressure by the middle of the bin, of the row at 1 s.
std::map<double, double> profile_of(const FinishedRun& run, const std::string& structure) {
  std::istringstream lines(run.text_of("series/pressure_profiles.csv"));
  std::map<double, double> pressure;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream fields(line);
    std::vector<std::string> field;  // structure, time, bottom, top, force x, force y, width, p
    for (std::string part; std::getline(fields, part, ',');) field.push_back(part);
    if (field[0] != structure || field[1] != "1") continue;
    pressure[0.5 * (std::stod(field[2]) + std::stod(field[3]))] = std::stod(field[7]);
  }
  return pressure;
}

TEST(LoadsRun, WaterAtRestPressesWithItsWeight) {
  const TemporaryFolder folder;
  std::ofstream(folder / "case.toml") << still_water;
  const FinishedRun run = run_to_end(folder / "case.toml", folder / "run", {});
  ASSERT_EQ(run.result.end, RunEnd::finished) << run.result.reason;
  const double expected = 0.5 * density * g * depth * depth * width;
  const auto last = run.last_row("series/loads.csv");
  EXPECT_NEAR(last.at("wall force x [N]"), expected, 0.02 * expected);
  EXPECT_NEAR(last.at("wall force y [N]"), 0, 0.01 * expected);
  EXPECT_NEAR(last.at("wall force z [N]"), 0, 0.01 * expected);
  EXPECT_NEAR(last.at("tank force x [N]"), -last.at("wall force x [N]"), 0.01 * expected);
  EXPECT_NEAR(last.at("wall hydrostatic [N]"), 0.5 * density * g * depth * depth * width, 15);
  EXPECT_NEAR(last.at("wall touched width [m]"), width, 1e-9);
  // It acts at a third of the depth; about the y axis that turns from z to x. The wall is as thick
  // as the water is deep, so that a weight on its foot would show.
  EXPECT_NEAR(last.at("wall moment y [N m]"), expected * depth / 3, 0.05 * expected * depth / 3);
  EXPECT_NE(run.text_of("manifest.toml").find("[[load]]"), std::string::npos);
  EXPECT_NE(run.text_of("index.html").find("series/pressure_profiles.csv"), std::string::npos);

  const auto gauges = run.last_row("series/gauges.csv");
  EXPECT_NEAR(gauges.at("middle depth [m]"), depth, 0.05 * depth);
  EXPECT_NEAR(gauges.at("middle surface [m]"), depth, 0.05 * depth);
  EXPECT_NEAR(gauges.at("middle pressure [Pa]"), density * g * depth, 0.05 * density * g * depth);
  EXPECT_NEAR(gauges.at("halfway up pressure [Pa]"), density * g * depth / 2,
              0.05 * density * g * depth);
  const auto sections = run.last_row("series/sections.csv");
  EXPECT_NEAR(sections.at("across area [m2]"), depth * width, 0.05 * depth * width);
  EXPECT_NEAR(sections.at("across mean speed [m/s]"), 0, 0.01);

  const auto pressure = profile_of(run, "wall");
  ASSERT_GE(pressure.size(), 10u);
  for (const auto& [z, p] : pressure) {
    if (z > depth) continue;
    EXPECT_NEAR(p, density * g * (depth - z), 0.03 * density * g * depth) << z;
  }
}

}  // namespace
}  // namespace sabo
