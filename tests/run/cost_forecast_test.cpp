#include "run/cost_forecast.hpp"

#include "support/temporary_folder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/case_file/read_case.hpp"
#include "run/new_case.hpp"

namespace sabo {
namespace {

using testing::HasSubstr;

/// h = 1 m, 10 s, c0 = 100 m/s, all at rest: a step is 0.5 x 1 / 100 = 5 ms, and a list holds on.
const CostSample at_rest{1000, 0, 0, 0.01, 0.005, 0, 100};
const CostOutlook still{Method::fast, 10, 1, 0.5, 100, 0, 0.15, 0, 1000, 0};

TEST(CostForecast, IsStepsTimesTheTimeOfAStep) {
  const CostForecast result = forecast(at_rest, still);
  EXPECT_NEAR(result.dt, 0.005, 1e-12);
  EXPECT_NEAR(result.steps, 2000, 1);
  EXPECT_NEAR(result.seconds, 2000 * 0.01, 0.02);
}

// A third of 75 m/s is 25 m/s: 0.5 / (100 + 25) = 4 ms. If the sound speed is ten times that of the
// flow, 0.5 / (250 + 25) s.
TEST(CostForecast, ShortensTheFastStepWithTheSpeed) {
  CostOutlook faster = still;
  faster.top_speed = 75;
  EXPECT_NEAR(forecast(at_rest, faster).dt, 0.004, 1e-12);
  faster.sound_factor = 10;
  EXPECT_NEAR(forecast(at_rest, faster).dt, 0.5 / 275, 1e-12);
}

// max(c0, 10 v): 25 m/s are beyond a tenth of the sound speed.
TEST(CostForecast, ShortensTheStepOfThePaperOnlyBeyondATenthOfTheSoundSpeed) {
  CostOutlook paper = still;
  paper.method = Method::paper;
  paper.top_speed = 30;
  EXPECT_NEAR(forecast(at_rest, paper).dt, 0.005, 1e-12);
  paper.top_speed = 75;
  EXPECT_NEAR(forecast(at_rest, paper).dt, 0.5 / 250, 1e-12);
}

// The sample was in an impact: 0.5 / (280 + 20) s. Later the flow has its slowest sound again.
TEST(CostForecast, LengthensTheStepWhenTheSoundSpeedFallsAgain) {
  CostSample impact = at_rest;
  impact.dt = 0.5 / 300;
  impact.sound_speed = 280;
  impact.speed = 20;
  EXPECT_NEAR(forecast(impact, still).dt, 0.5 / 120, 1e-12);
}

TEST(CostForecast, KeepsAStepThatAnotherLimitRules) {
  CostSample viscous = at_rest;
  viscous.dt = 0.001;
  EXPECT_NEAR(forecast(viscous, still).dt, 0.001, 1e-12);
}

// At 10 m/s and 0.5 / 110 s a step, 0.15 m take 3.3 steps; a list of 33 ms adds 10 ms a step.
TEST(CostForecast, AddsAListEachTimeTheFlowHasGoneItsReach) {
  CostSample sample = at_rest;
  sample.list_seconds = 0.033;
  CostOutlook moving = still;
  moving.top_speed = 30;
  EXPECT_NEAR(forecast(sample, moving).seconds, 2200 * (0.01 + 0.01), 0.1);
}

// 1000 of the flow and 2000 of the ground weigh 1500; with 6000 at the end, 4000 in the mean, 2000.
// A tenth of the particles was stepped.
TEST(CostForecast, GrowsWithTheGroundAndTheWholeRelease) {
  CostSample sample = at_rest;
  sample.boundary = 2000;
  CostOutlook wide = still;
  wide.fluid = 10000;
  wide.latest_ground = 60000;
  EXPECT_NEAR(forecast(sample, wide).seconds, 20 * (2000.0 / 1500) * 10, 0.2);
}

TEST(CostForecast, IsSaidWithItsRange) {
  EXPECT_EQ(forecast_text({360, 33000, 0.009, 2}),
            "about 6 min on 2 threads (3 to 12 min), 33 thousand steps of 9 ms");
  EXPECT_THAT(forecast_text({360, 33000, 0.009, 2, false, true}),
              HasSubstr("about 6 min on the graphics card (3 to 12 min)"));
  EXPECT_THAT(forecast_text({360, 33000, 0.009, 2, true}),
              HasSubstr("uncertain, for other programs run"));
  EXPECT_EQ(forecast_text({20, 2000, 0.005, 1}),
            "about 20 s on 1 thread (10 to 40 s), 2000 steps of 5 ms");
  EXPECT_THAT(forecast_text({7200, 1e6, 0.001, 1}), HasSubstr("about 2 h on 1 thread (1 to 4 h)"));
}

class MeasuredForecast : public testing::Test {
 protected:
  Case example(const std::vector<Override>& overrides) {
    new_case("yohutagawa", folder_ / "demo");
    const Case c = read_case(folder_ / "demo", faults_, overrides);
    faults_.throw_if_any();
    return c;
  }
  const TemporaryFolder folder_;
  Faults faults_;
};

// c0 = 10 x 20 m/s and h = 6 m: fast 0.6 x 6 / (200 + 20/3 or the sliding speed), and 0.2 x 6 / 200
// = 6 ms; viscosity allows 0.6 h^2 / (1.255e6/1726) = 30 ms.
TEST_F(MeasuredForecast, HasTheStepsOfTheMethod) {
  const std::vector<Override> coarse{{"numerics", "spacing", 4.0},
                                     {"numerics", "threads", std::int64_t{1}},
                                     {"run", "duration", 5.0}};
  Case c = example(coarse);
  const Scene scene = make_scene(c, faults_);
  EXPECT_NEAR(measured_forecast(c, scene).dt, 0.006, 1e-9);
  EXPECT_GT(measured_forecast(c, scene).seconds, 0);
  c.numerics.method = Method::fast;
  c.numerics.cfl = 0.6;
  const double dt = measured_forecast(c, scene).dt;
  EXPECT_LE(dt, 0.6 * 6 / 200);
  EXPECT_GE(dt, 0.6 * 6 / (200 + 20.0 / 3));
  EXPECT_EQ(measured_forecast(c, scene).threads, 1);
}

// Without friction the path's fall of 291 m would give 76 m/s: at most 30, or the reference speed.
// With 60 degrees the mass does not slide at all.
TEST_F(MeasuredForecast, BoundsTheSpeedByFallAndFriction) {
  Case c = example({});
  const Scene scene = make_scene(c, faults_);
  EXPECT_LE(speed_bound(c, scene), 20);
  c.numerics.reference_speed = 0;
  c.material.yield.friction_angle = 0;
  EXPECT_EQ(speed_bound(c, scene), 30);
  c.material.yield.friction_angle = 60;
  EXPECT_EQ(speed_bound(c, scene), 0);
}

}  // namespace
}  // namespace sabo
