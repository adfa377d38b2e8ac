#pragma once

#include <algorithm>
#include <map>
#include <random>

#include "support/scenes.hpp"
#include <gtest/gtest.h>

// Random clouds that every backend is given, and how far apart their results are.

namespace sabo::test {

enum class Cloud { free, periodic, far };

/// A jittered block over a jittered floor, every particle with its own velocity, density and mass;
/// `across` cells wide.
inline void fill(Backend& backend, const Vec3d& offset, int across = 8) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> u(-1, 1);
  const double dp = backend.model().spacing;
  const bool flat = backend.model().dimension == 2;
  for (int k = -3; k < 6; ++k)
    for (int j = 0; j < (flat ? 1 : across); ++j)
      for (int i = 0; i < across; ++i) {
        Particles& set = k < 0 ? backend.boundary() : backend.fluid();
        const double y = flat ? 0 : (j + 0.5 + 0.2 * u(random)) * dp;
        add_particle(
            set, backend.model(),
            offset + Vec3d{(i + 0.5 + 0.2 * u(random)) * dp, y, (k + 0.5 + 0.2 * u(random)) * dp},
            k < 0 ? Vec3d{} : Vec3d{u(random), flat ? 0 : u(random), u(random)});
        set.density.back() *= 1 + 0.02 * u(random);
        set.mass.back() *= 1 + 0.1 * u(random);
      }
}

inline FlowModel in_cloud(FlowModel model, Cloud cloud) {
  if (cloud == Cloud::periodic)
    model.periodic.period = {Vec3d{0.8, 0, -0.2}, model.dimension == 2 ? Vec3d{} : Vec3d{0, 0.8, 0},
                             Vec3d{}};
  return model;
}

/// Exact in binary, so that the two clouds are the same to the last bit.
inline Vec3d offset_of(Cloud cloud, const FlowModel& model) {
  return cloud == Cloud::far ? Vec3d{10240, model.dimension == 2 ? 0.0 : -10240, 1024} : Vec3d{};
}

/// Largest difference over largest value.
template <class Values, class Norm>
double difference(const Values& a, const Values& b, const Norm& size) {
  EXPECT_EQ(a.size(), b.size());
  double largest = 0, apart = 0;
  for (const auto& [id, value] : a) {
    largest = std::max(largest, size(value));
    apart = std::max(apart, size(value - b.at(id)));
  }
  EXPECT_GT(largest, 0);
  return apart / largest;
}

}  // namespace sabo::test
