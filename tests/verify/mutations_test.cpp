// A case that no longer fails when a term is broken would tell nothing.

#include <algorithm>
#include <cmath>

#include "verify/verification.hpp"
#include <gtest/gtest.h>

namespace sabo {
namespace {

/// Whether the quick form of a case meets the claims of a name's start with the model broken so;
/// with the right one it does, as the tests of all cases show.
bool holds_with(std::string_view name, std::string_view claims,
                std::function<void(FlowModel&)> alter) {
  VerifySettings settings;
  settings.effort = Effort::quick;
  settings.alter = std::move(alter);
  const auto verification = std::ranges::find(verifications(), name, &Verification::name);
  const Verdict verdict = verification->run(settings);
  const auto is_meant = [&](const Claim& claim) { return claim.what.starts_with(claims); };
  EXPECT_TRUE(std::ranges::any_of(verdict.claims, is_meant)) << name << " has no " << claims;
  return std::ranges::all_of(verdict.claims,
                             [&](const Claim& c) { return !is_meant(c) || c.holds(); });
}

TEST(Mutations, TwiceTheViscosityFailsTheStartUp) {
  EXPECT_FALSE(holds_with("startup", "Poiseuille, 20 across, 0.1125 s",
                          [](FlowModel& model) { std::get<Newtonian>(model.rheology).mu *= 2; }));
}

// B = c0^2 rho0, without the division by gamma, is the stiffness of a speed of sound greater by
// the square root of 7.
TEST(Mutations, AnEquationOfStateWithoutGammaFailsTheFluidAtRest) {
  EXPECT_FALSE(holds_with("hydrostatic", "column, spacing H/20: density",
                          [](FlowModel& model) { model.state.c0 *= std::sqrt(7.0); }));
}

TEST(Mutations, AnotherFrictionAngleFailsTheSlab) {
  EXPECT_FALSE(holds_with("slab", "33°, μ0/μB 1000, 10 layers: speed",
                          [](FlowModel& model) { model.yield.friction_angle = 45; }));
}

}  // namespace
}  // namespace sabo
