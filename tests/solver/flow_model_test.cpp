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

double shifting(NumericsCase numerics, const Rheology& law) {
  numerics.spacing = 1;
  MaterialCase material;
  material.law = law;
  return flow_model(material, numerics, 1).particle_shifting;
}

TEST(FlowModel, ShiftsParticlesByItsLawOrAsIsAsked) {
  NumericsCase numerics;
  EXPECT_EQ(shifting(numerics, Cross{}), 40);
  EXPECT_EQ(shifting(numerics, Newtonian{}), 20);
  numerics.particle_shifting = 0;
  EXPECT_EQ(shifting(numerics, Cross{}), 0);
  NumericsCase paper;
  paper.method = Method::paper;
  EXPECT_EQ(shifting(paper, Cross{}), 0);
}

}  // namespace
}  // namespace sabo
