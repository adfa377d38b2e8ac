#include "physics/layered_viscosity.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace sabo {
namespace {

/// Sum of -F z^2 over a lattice of spacing 1 whose layers have slid by a place of their own, the
/// mean over all places.
double mean_over_places(double h, int dimension) {
  constexpr int places = 16;
  const auto kernel = WendlandC2<double>::make(h, dimension);
  const int reach = static_cast<int>(2 * h) + 2, across = dimension == 3 ? reach : 0;
  const int places_across = dimension == 3 ? places : 1;
  double sum = 0;
  for (int a = 0; a < places; ++a)
    for (int b = 0; b < places_across; ++b)
      for (int z = -reach; z <= reach; ++z)
        for (int y = -across; y <= across; ++y)
          for (int x = -reach; x <= reach; ++x) {
            const double along = x + double(a) / places, beside = y + double(b) / places;
            const double r = std::sqrt(along * along + beside * beside + z * z);
            sum -= kernel.gradient_factor(r) * z * z;
          }
  return sum / (places * places_across);
}

TEST(LayeredViscosity, IsTheMeanOverLayersThatSlide) {
  for (const int dimension : {2, 3})
    for (const double h : {1.2, 1.5, 2.0})
      EXPECT_NEAR(layered_viscosity(WendlandC2<double>::make(h, dimension), dimension, 1),
                  mean_over_places(h, dimension), 2e-5)
          << dimension << "D, h/dp " << h;
}

TEST(LayeredViscosity, KnownValues) {
  EXPECT_NEAR(layered_viscosity(WendlandC2<double>::make(1.2, 2), 2, 1), 0.963, 5e-4);
  EXPECT_NEAR(layered_viscosity(WendlandC2<double>::make(1.5, 2), 2, 1), 0.9966, 1e-4);
  EXPECT_NEAR(layered_viscosity(WendlandC2<double>::make(0.12, 3), 3, 0.1), 0.979, 5e-4);
  EXPECT_NEAR(layered_viscosity(WendlandC2<double>::make(0.15, 3), 3, 0.1), 0.9986, 1e-4);
}

TEST(LayeredViscosity, IsOneForManyLayers) {
  for (const int dimension : {2, 3})
    EXPECT_NEAR(layered_viscosity(WendlandC2<double>::make(1, dimension), dimension, 0.05), 1,
                1e-3);
}

}  // namespace
}  // namespace sabo
