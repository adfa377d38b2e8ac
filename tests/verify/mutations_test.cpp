// A case that no longer fails when a term is broken would tell nothing.

#include <cmath>

#include "verify/verification.hpp"
#include <gtest/gtest.h>

namespace sabo {
namespace {

/// Whether the quick form of a case holds with the model broken so.
bool holds_with(std::string_view name, std::function<void(FlowModel&)> alter) {
  VerifySettings settings;
  settings.effort = Effort::quick;
  settings.alter = std::move(alter);
  for (const Verification& v : verifications())
    if (v.name == name) return v.run(settings).holds();
  ADD_FAILURE() << "there is no case " << name;
  return true;
}

TEST(Mutations, TwiceTheViscosityFailsTheStartUp) {
  EXPECT_FALSE(
      holds_with("startup", [](FlowModel& model) { std::get<Newtonian>(model.rheology).mu *= 2; }));
}

// B = c0^2 rho0, without the division by gamma, is the stiffness of a speed of sound greater by
// the square root of 7.
TEST(Mutations, AnEquationOfStateWithoutGammaFailsTheFluidAtRest) {
  EXPECT_FALSE(
      holds_with("hydrostatic", [](FlowModel& model) { model.state.c0 *= std::sqrt(7.0); }));
}

TEST(Mutations, AnotherFrictionAngleFailsTheSlab) {
  EXPECT_FALSE(holds_with("slab", [](FlowModel& model) { model.yield.friction_angle = 45; }));
}

}  // namespace
}  // namespace sabo
