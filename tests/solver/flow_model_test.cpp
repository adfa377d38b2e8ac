#include "solver/flow_model.hpp"

#include <gtest/gtest.h>

namespace sabo {
namespace {

bool bears(SurfaceTension tension, const Rheology& law) {
  NumericsCase numerics;
  numerics.spacing = 1;
  numerics.tension_at_surface = tension;
  MaterialCase material;
  material.law = law;
  return flow_model(material, numerics, 1).tension_at_surface;
}

TEST(FlowModel, BearsTensionBesideTheAirByItsLawOrAsIsAsked) {
  EXPECT_TRUE(bears(SurfaceTension::by_law, Cross{}));
  EXPECT_FALSE(bears(SurfaceTension::by_law, Newtonian{}));
  EXPECT_TRUE(bears(SurfaceTension::borne, Newtonian{}));
  EXPECT_FALSE(bears(SurfaceTension::none, Cross{}));
}

}  // namespace
}  // namespace sabo
