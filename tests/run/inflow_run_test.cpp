#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "support/folders.hpp"
#include "support/temporary_folder.hpp"
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/section.hpp"
#include "analysis/tracks.hpp"
#include "base/error.hpp"
#include "io/output/plan_file.hpp"
#include "math/angle.hpp"
#include "run/channel.hpp"
#include "run/cost_forecast.hpp"
#include "run/finished_run.hpp"
#include "run/flow.hpp"
#include "run/memory_estimate.hpp"
#include "run/preview.hpp"
#include "run/scene_of.hpp"
#include "solver/flow_model.hpp"
#include "terrain/bilinear.hpp"

// Inflows into the channel, particles of 0.25 m.

namespace sabo {
namespace {

using testing::HasSubstr;
using testing::Not;

Case case_of(const std::string& text, const std::string& numerics = "wall = \"slip\"\n") {
  Faults faults;
  Case c = read_case_text(channel + text +
                              "\n[run]\nduration = 8\n[numerics]\nspacing = 0.25\nthreads = 1\n" +
                              numerics,
                          repository() / "examples/inflow", faults);
  for (const Fault& fault : faults.list()) ADD_FAILURE() << to_string(fault);
  return c;
}

/// What is wrong with an inflow of the channel, given by its keys.
std::string fault_of_inflow(const std::string& keys) {
  Faults faults;
  const Case c = case_of("[[inflow]]\n" + keys);
  make_scene(c, faults);
  return faults.empty() ? "" : to_string(faults.list().front());
}

Particles sorted_by_number(const Particles& fluid) {
  std::vector<std::uint32_t> order(fluid.size());
  for (std::uint32_t i = 0; i < fluid.size(); ++i) order[i] = i;
  std::ranges::sort(order, {}, [&](std::uint32_t i) { return fluid.id[i]; });
  Particles sorted = fluid;
  sorted.permute(order);
  return sorted;
}

/// A steady inflow after some time (s).
Particles state_at(double time, const NumericsCase& numerics) {
  Case c = case_of(inflow + steady);
  c.numerics = numerics;
  const Scene scene = scene_of(c);
  Flow flow(c, scene);
  flow.stepper().advance_to(time);
  return sorted_by_number(flow.backend().fluid());
}

// A twentieth: particles pass one by one, 16 times 8 a second, and the surface waves.
TEST(Inflow, BringsItsDischargeAtEachTimeAndToASectionDownstream) {
  const Case c = case_of(inflow + steady);
  const Scene scene = scene_of(c);
  const InflowPlan& plan = scene.inflows.front();
  EXPECT_NEAR(plan.flow_at_peak().depth, 1 / std::cos(3 * degree), 0.01);
  Flow flow(c, scene);
  const Vec3d origin{scene.frame.origin_x, scene.frame.origin_y, 0};
  Section section({{Vec3d{6, 1.4, 0} - origin, Vec3d{6, 3.6, 0} - origin}, false});
  Tracks tracks;
  const double layer = 32 * plan.particle_volume();
  double before = 0;
  constexpr double from = 3.5, to = 6;
  while (flow.stepper().time() < to) {
    flow.stepper().step(to - flow.stepper().time());
    const double time = flow.stepper().time();
    const double entered = flow.domain().inflows().front().entered();
    ASSERT_LE(entered, 5 * time + 0.5 * plan.particle_volume()) << time;
    ASSERT_GE(entered, 5 * time - 1.1 * layer) << time;
    const Particles& fluid = flow.backend().fluid();
    section.record(tracks.advance(fluid), fluid, 1000);
    if (time < from) before = section.total().net();
  }
  const double discharge = (section.total().net() - before) / (to - from);
  RecordProperty("discharge", std::to_string(discharge));
  EXPECT_NEAR(discharge, 5, 0.25);
}

TEST(Inflow, LeavesNoGapBehindTheLine) {
  const Particles fluid = state_at(3, case_of(inflow + steady).numerics);
  std::vector<double> stations{1};  // of the line, then those of the particles near it
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    if (fluid.position[i].x > 5) continue;  // drops of the front are torn from the rest
    // Where the front thins out water tears, down to 3 % less (docs/method.md, Tension).
    EXPECT_NEAR(fluid.density[i], 1000, fluid.position[i].x < 4.25 ? 10 : 30);
    stations.push_back(fluid.position[i].x);
  }
  std::ranges::sort(stations);
  EXPECT_EQ(stations[0], 1);
  for (std::size_t k = 1; k < stations.size(); ++k)
    EXPECT_LT(stations[k] - stations[k - 1], 1.01 * 0.25) << stations[k];
  // Layers of 32 particles, 4 to a metre.
  EXPECT_NEAR(static_cast<double>(stations.size()), 4 * 4 * 32, 100);
}

TEST(Inflow, BringsTwoSurgesWithAGapToTheLastParticle) {
  const std::string surges =
      "[[inflow.surge]]\nstart = 0.2\npeak_time = 0.6\nend = 1\npeak_discharge = 6\n"
      "[[inflow.surge]]\nstart = 2.5\npeak_time = 2.7\nend = 3\npeak_discharge = 4\n";
  const Case c = case_of(inflow + surges);
  const Scene scene = scene_of(c);
  Flow flow(c, scene);
  const Inflow& apex = flow.domain().inflows().front();
  const double half_a_particle = 0.51 * scene.inflows.front().particle_volume();
  flow.stepper().advance_to(2.4);
  EXPECT_NEAR(apex.entered(), 2.4, half_a_particle);
  EXPECT_FALSE(flow.domain().inflows_are_over(2.4));
  flow.stepper().advance_to(5);
  EXPECT_NEAR(apex.entered(), 3.4, half_a_particle);
  EXPECT_TRUE(flow.domain().inflows_are_over(5));
  const Particles& fluid = flow.backend().fluid();
  EXPECT_EQ(std::ranges::count(fluid.driven, 0), static_cast<long>(fluid.size()));
  EXPECT_EQ(flow.domain().take_entered().size(),
            fluid.size() + flow.domain().take_departed().size());
}

TEST(Inflow, HasTheSameBitsForAnyNumberOfThreads) {
  NumericsCase numerics = case_of(inflow + steady).numerics;
  const Particles one = state_at(1.2, numerics);
  numerics.threads = 3;
  const Particles three = state_at(1.2, numerics);
  ASSERT_GT(one.size(), 300u);
  EXPECT_EQ(one.position, three.position);
  EXPECT_EQ(one.velocity, three.velocity);
  EXPECT_EQ(one.density, three.density);
}

/// Where two states of the same particles differ most, m/s.
double most_apart(const Particles& a, const Particles& b) {
  EXPECT_EQ(a.id, b.id);
  double most = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    most = std::max(most, norm(a.velocity[i] - b.velocity[i]));
  return most;
}

// The sums of one are in single precision.
TEST(Inflow, IsTheSameOnBothBackends) {
  for (const char* method : {"fast", "paper"}) {
    NumericsCase numerics =
        case_of(inflow + steady, "method = \"" + std::string(method) + "\"\n").numerics;
    const Particles cpu = state_at(0.55, numerics);
    ASSERT_GT(std::ranges::count(cpu.driven, 0), 30) << method;
    ASSERT_GT(std::ranges::count(cpu.driven, 1), 30) << method;
    numerics.backend = BackendKind::reference;
    EXPECT_LT(most_apart(state_at(0.55, numerics), cpu), 0.01) << method;
  }
}

TEST(InflowScene, SaysWhatIsWrongWithALine) {
  const std::string discharge = "[[inflow.surge]]\npeak_time = 1\nend = 2\npeak_discharge = 5\n";
  EXPECT_EQ(fault_of_inflow("line = [[1, 1.5], [1, 3.5]]\n" + discharge), "");
  EXPECT_THAT(fault_of_inflow("line = [[1, 2], [1, 3.5]]\n" + discharge),
              HasSubstr("above the ground at the line's first end"));
  EXPECT_THAT(fault_of_inflow("line = [[-1, 1.5], [-1, 3.5]]\n" + discharge),
              HasSubstr("lies beside the DEM"));
  EXPECT_THAT(fault_of_inflow("line = [[-1, 1.5], [1, 1.5]]\n" + discharge),
              HasSubstr("lies outside the DEM"));
  EXPECT_THAT(fault_of_inflow("line = [[1, 1.5], [1, 3], [1.1, 2], [1.2, 3.5]]\n" + discharge),
              HasSubstr("turns back"));
  EXPECT_THAT(fault_of_inflow("line = [[1, 1], [1, 3.5]]\n" + discharge),
              HasSubstr("a structure or body stands in the first 1 m"));
  EXPECT_THAT(fault_of_inflow("line = [[5, 2.5], [8, 2.5]]\n" + discharge),
              HasSubstr("does not fall to either side"));
}

TEST(InflowScene, RefusesAReleaseInItsWay) {
  Faults faults;
  const Case c = case_of(inflow + steady + "[release]\nbox = [1.5, 2, 0, 3, 3, 1]\n");
  make_scene(c, faults);
  ASSERT_EQ(faults.list().size(), 1u);
  EXPECT_THAT(to_string(faults.list()[0]), HasSubstr("the release lies in the first 1 m"));
}

TEST(InflowScene, IsToldOfBeforeTheRun) {
  const Case c = case_of(inflow +
                         "froude = 1\n[[inflow.surge]]\npeak_time = 4\nend = 10\n"
                         "peak_discharge = 2\n");
  const std::string text = preview_text(c, scene_of(c));
  EXPECT_THAT(text, HasSubstr("apex: 10 m3 until 10 s, at most 2 m3/s at 4 s, to the east on a "
                              "slope of 3.0 deg"));
  EXPECT_THAT(text, HasSubstr("particles deep at its peak"));
  EXPECT_THAT(text, HasSubstr("the run ends before the inflow \"apex\" does"));
  EXPECT_THAT(text, Not(HasSubstr("Release")));
}

TEST(Inflow, HasNoForecastWhereNothingComes) {
  const Case c = case_of(inflow +
                         "speed = 1\n[[inflow.surge]]\nstart = 100\npeak_time = 101\nend = 110\n"
                         "peak_discharge = 2\n");
  EXPECT_THROW(measured_forecast(c, scene_of(c)), RunError);
}

TEST(InflowRun, HasABalanceToTheLastParticle) {
  const TemporaryFolder folder;
  const FinishedRun run = run_to_end(repository() / "examples/inflow", folder / "run",
                                     {{"run", "duration", 6.0}, {"numerics", "spacing", 1.0}});
  EXPECT_EQ(run.result.end, RunEnd::finished);
  const auto volumes = run.last_row("series/volumes.csv");
  const double entered = volumes.at("apex entered [m3]");
  EXPECT_NEAR(volumes.at("apex hydrograph [m3]"), 70 + 3 * 47.5 + 25 - 25.0 / 8, 0.01);
  EXPECT_NEAR(entered, volumes.at("apex hydrograph [m3]"), 6);
  EXPECT_NEAR(volumes.at("released [m3]"), entered, 1e-9);
  EXPECT_NEAR(run.volume_of("maps/dep.tif"), entered - volumes.at("outflow [m3]"), 1e-3);
  // What came in and the work that pushed it is found again (docs/outputs.md, Energy).
  const auto energy = run.last_row("series/energy.csv");
  const double brought = energy.at("brought by inflows [J]");
  double found = 0;
  for (const char* part : {"kinetic [J]", "potential [J]", "elastic [J]", "dissipated [J]",
                           "numerical [J]", "left the map [J]"})
    found += energy.at(part);
  EXPECT_NEAR(found / brought, 1, 1e-3);
  const std::string manifest = run.text_of("manifest.toml");
  EXPECT_THAT(manifest, HasSubstr("[[inflow]]\ninflow = \"apex\"\n"));
  EXPECT_THAT(manifest, HasSubstr("hydrograph.csv"));  // among the checksums
  EXPECT_THAT(run.result.summary, testing::Contains(HasSubstr("Inflow apex: hydrograph 234")));

  // Its walls follow the ground, 4 m above it, in the plan as well.
  const std::vector<MapLine> plan = read_plan(run.folder / "maps" / "plan.geojson");
  const auto wall = std::ranges::find(plan, "left bank", &MapLine::label);
  ASSERT_NE(wall, plan.end());
  ASSERT_TRUE(wall->line.has_z);
  const Raster ground = RasterFile(run.folder / "maps" / "ground.tif", "map").read();
  for (const Vec3d& vertex : wall->line.vertices)
    EXPECT_NEAR(vertex.z, bilinear(ground, vertex.x, vertex.y, Raster::no_data) + 4, 0.01);
}

TEST(Inflow, IsCountedInTheMemoryOfACard) {
  Case c = case_of(inflow + steady);
  c.numerics.backend = BackendKind::cuda;
  const Scene scene = scene_of(c);
  EXPECT_EQ(scene.release.size(), 0u);
  const double needed =
      expected_card_memory(flow_model(c.material, c.numerics, scene.greatest_depth()),
                           c.numerics.method, scene.particles_until(c.run.duration));
  EXPECT_THAT(preview_text(c, scene, ""),
              HasSubstr(fmt::format("about {:.0f} MB of the graphics card", needed / 1e6)));
  EXPECT_GT(needed, 1e6);
}

}  // namespace
}  // namespace sabo
