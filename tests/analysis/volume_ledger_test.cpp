#include "analysis/volume_ledger.hpp"

#include "cloud.hpp"
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "analysis/tracks.hpp"

namespace sabo {
namespace {

/// Runs north at x = 10; the flow comes from the west.
const Polyline dam_axis{{{10, 0, 0}, {10, 100, 0}}};
const Vec3d upstream{0, 50, 0};

TEST(VolumeLedger, follows_four_particles) {
  VolumeLedger ledger(2000, dam_axis, upstream);
  Tracks tracks;
  Particles particles = cloud({{5, 10, 0}, {5, 20, 0}, {5, 30, 0}, {5, 40, 0}}, 1000);  // 0.5 m3
  ledger.release(particles);
  tracks.advance(particles);
  EXPECT_EQ(ledger.row().released, 2);
  EXPECT_EQ(ledger.row().trapped, 2);

  particles.position = {{5, 10, 0}, {15, 20, 0}, {15, 30, 0}, {15, 40, 0}};
  ledger.record(tracks.advance(particles), particles);
  EXPECT_EQ(ledger.row().beyond, 1.5);
  EXPECT_EQ(ledger.row().trapped, 0.5);

  particles.position[3] = {9, 40, 0};  // comes back
  ledger.record(tracks.advance(particles), particles);
  EXPECT_EQ(ledger.row().beyond, 1);
  EXPECT_EQ(ledger.row().trapped, 1);

  Particles leaving = particles;  // one from above the dam, one from below it
  leaving.permute({0, 1});
  ledger.leave(leaving);
  ledger.put_back(3);
  ledger.put_back(1);
  const VolumeRow row = ledger.row();
  EXPECT_EQ(row.released, 2);
  EXPECT_EQ(row.outflow, 1);
  EXPECT_EQ(row.beyond, 0.5);
  EXPECT_EQ(row.trapped, 0.5);
  EXPECT_EQ(row.put_back, 4u);
}

TEST(VolumeLedger, the_direction_in_which_the_dam_was_drawn_does_not_matter) {
  const Polyline drawn_southwards{{{10, 100, 0}, {10, 0, 0}}};
  for (const Polyline& axis : {dam_axis, drawn_southwards}) {
    VolumeLedger ledger(1000, axis, upstream);
    const Particles particles = cloud({{11, 50, 0}}, 1000);
    ledger.release(particles);
    ledger.record({{9, 50, 0}}, particles);
    EXPECT_EQ(ledger.row().beyond, 1);
  }
}

TEST(VolumeLedger, without_a_dam_all_that_stays_is_trapped) {
  VolumeLedger ledger(1000);
  const Particles particles = cloud({{11, 50, 0}, {12, 50, 0}}, 1000);
  ledger.release(particles);
  ledger.record({{9, 50, 0}, {9, 50, 0}}, particles);
  EXPECT_EQ(ledger.row().beyond, 0);
  EXPECT_EQ(ledger.row().trapped, 2);
}

// Whole masses and a density of 1 make all sums exact.
TEST(VolumeLedger, agrees_with_a_count_of_sides_for_any_walk) {
  EXPECT_TRUE(rc::check("trapped, beyond and outflow = counts by place", [] {
    const auto place = [] { return Vec3d{*rc::gen::inRange(0, 20) + 0.5, 50, 0}; };
    const auto count = *rc::gen::inRange<std::size_t>(1, 12);
    Particles particles = cloud(std::vector<Vec3d>(count, upstream));
    for (double& mass : particles.mass) mass = *rc::gen::inRange(1, 100);
    VolumeLedger ledger(1, dam_axis, upstream);
    Tracks tracks;
    ledger.release(particles);
    tracks.advance(particles);
    const double released = ledger.row().released;

    double outflow = 0;
    for (int step = 0; step < 12; ++step) {
      for (Vec3d& position : particles.position) position = place();
      ledger.record(tracks.advance(particles), particles);
      if (particles.size() > 1 && *rc::gen::inRange(0, 3) == 0) {
        std::vector<std::uint32_t> staying(particles.size() - 1);
        for (std::uint32_t k = 0; k < staying.size(); ++k) staying[k] = k + 1;
        Particles leaving = particles;
        leaving.permute({0});
        ledger.leave(leaving);
        outflow += leaving.mass[0];
        particles.permute(staying);
      }
      double beyond = 0;
      double trapped = 0;
      for (std::size_t i = 0; i < particles.size(); ++i) {
        (particles.position[i].x > 10 ? beyond : trapped) += particles.mass[i];
      }
      const VolumeRow row = ledger.row();
      RC_ASSERT(row.beyond == beyond);
      RC_ASSERT(row.trapped == trapped);
      RC_ASSERT(row.outflow == outflow);
      RC_ASSERT(row.released == released);
      RC_ASSERT(row.released == row.trapped + row.beyond + row.outflow);
    }
  }));
}

}  // namespace
}  // namespace sabo
