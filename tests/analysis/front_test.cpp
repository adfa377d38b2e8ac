#include "analysis/front.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "cloud.hpp"
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "base/error.hpp"

namespace sabo {
namespace {

const Polyline eastwards{{{0, 0, 0}, {100, 0, 0}}};

TEST(Front, is_the_mean_of_the_foremost_hundredth) {
  // 300 equal particles at stations 0 ... 299: the foremost three have the mean 298.
  std::vector<Vec3d> points;
  for (int k = 0; k < 300; ++k) points.push_back({static_cast<double>((k * 7) % 300), 0, 0});
  EXPECT_DOUBLE_EQ(Front({{{0, 0, 0}, {500, 0, 0}}}).update(0, cloud(points)).position, 298);
}

TEST(Front, the_last_particle_counts_in_part) {
  // 150 equal particles at stations 0 ... 149: one and a half of them, (149 + 148 / 2) / 1.5.
  std::vector<Vec3d> points;
  for (int k = 0; k < 150; ++k) points.push_back({static_cast<double>(k), 0, 0});
  EXPECT_DOUBLE_EQ(Front(eastwards).update(0, cloud(points)).position, (149 + 74) / 1.5);
}

TEST(Front, counts_mass_not_particles) {
  Particles particles = cloud({{50, 0, 0}, {40, 0, 0}, {0, 0, 0}}, 1);
  particles.mass = {1, 1, 198};  // the hundredth is 2
  EXPECT_DOUBLE_EQ(Front(eastwards).update(0, particles).position, 45);
}

TEST(Front, displacement_and_velocity_follow_the_position) {
  Front front(eastwards);
  const FrontRow first = front.update(10, cloud({{20, 3, 0}}));
  EXPECT_EQ(first.position, 20);
  EXPECT_EQ(first.displacement, 0);
  EXPECT_EQ(first.velocity, 0);
  EXPECT_EQ(front.update(12, cloud({{26, 3, 0}})).velocity, 3);
  const FrontRow back = front.update(12.5, cloud({{25, 3, 0}}));
  EXPECT_EQ(back.displacement, 5);
  EXPECT_EQ(back.velocity, -2);
  const FrontRow gone = front.update(13, Particles{});
  EXPECT_EQ(gone.position, 25);
  EXPECT_EQ(gone.velocity, 0);
}

TEST(Front, passes_the_ends_of_the_path) {
  EXPECT_EQ(Front(eastwards).update(0, cloud({{130, 5, 0}})).position, 130);
  EXPECT_EQ(Front(eastwards).update(0, cloud({{-30, 5, 0}})).position, -30);
}

TEST(Front, needs_a_path) {
  EXPECT_THROW(Front({{{1, 1, 0}}}), CaseError);
  EXPECT_THROW(Front({{{1, 1, 0}, {1, 1, 9}}}), CaseError);
}

/// The definition, on all particles.
double foremost_by_sorting(const Polyline& path, const Particles& particles, double share) {
  std::vector<double> stations;
  for (const Vec3d& point : particles.position) {
    stations.push_back(project(path, point.x, point.y).station);
  }
  std::sort(stations.rbegin(), stations.rend());
  double left = share * static_cast<double>(stations.size());
  const double weight = left;
  double sum = 0;
  for (const double station : stations) {
    sum += std::min(left, 1.0) * station;
    left -= std::min(left, 1.0);
  }
  return sum / weight;
}

// Many points, so that there are many bins, around a path that winds about and crosses itself, and
// beyond both its ends.
TEST(StationIndex, agrees_with_projecting_every_point) {
  EXPECT_TRUE(rc::check("bins and candidates change nothing", [] {
    std::mt19937 random(*rc::gen::arbitrary<unsigned>());
    const auto between = [&](double low, double high) {
      return std::uniform_real_distribution<double>(low, high)(random);
    };
    Polyline path{{{0, 0, 0}, {5, 0, 0}}};
    const double winding = between(0, 20);
    const double advance = between(1, 40);
    const int bends = *rc::gen::inRange(0, 40);
    for (int k = 0; k < bends; ++k) {
      const Vec3d step{between(-winding, winding) + advance, between(-winding, winding), 0};
      path.vertices.push_back(path.vertices.back() + step);
    }
    std::vector<Vec3d> points(2000);
    const double width = between(0.1, 80);
    for (Vec3d& point : points) {
      point = point_at(path, between(-0.3, 1.3) * length(path));
      point += Vec3d{between(-width, width), between(-width, width), 0};
    }
    const double share = between(0.001, 1);
    const Particles particles = cloud(points);
    const double expected = foremost_by_sorting(path, particles, share);
    const double found = *StationIndex(path).foremost(points, particles.mass, share);
    RC_ASSERT(std::abs(found - expected) < 1e-9);
  }));
}

}  // namespace
}  // namespace sabo
