#include "solver/flow_model.hpp"

#include <gtest/gtest.h>

namespace sabo {
namespace {

bool bears(TensionAtSurface tension, const Rheology& law) {
  NumericsCase numerics;
  numerics.spacing = 1;
  numerics.tension_at_surface = tension;
  MaterialCase material;
  material.law = law;
  return flow_model(material, numerics, 1).tension_at_surface;
}

TEST(FlowModel, BearsTensionBesideTheAirByItsLawOrAsIsAsked) {
  EXPECT_TRUE(bears(TensionAtSurface::by_law, Cross{}));
  EXPECT_FALSE(bears(TensionAtSurface::by_law, Newtonian{}));
  EXPECT_TRUE(bears(TensionAtSurface::borne, Newtonian{}));
  EXPECT_FALSE(bears(TensionAtSurface::none, Cross{}));
}

}  // namespace
}  // namespace sabo
