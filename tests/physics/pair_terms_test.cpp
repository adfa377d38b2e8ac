#include <cmath>

#include <gtest/gtest.h>

#include "physics/pair/density.hpp"
#include "physics/pair/forces.hpp"
#include "physics/pair/strain_rate.hpp"
#include "physics/pair/wall_contact.hpp"

namespace sabo {
namespace {

// A pair at distance 5 along (3, 0, 4) with F = -2, so that every term is a hand calculation.
const PairGeometry<double> pair{{3, 0, 4}, 25, -2};

TEST(Continuity, ApproachingParticlesGainDensity) {
  EXPECT_DOUBLE_EQ(continuity(pair, Vec3d{-1, 7, 0}, 10.0), 10 * -2 * -3);
  EXPECT_DOUBLE_EQ(continuity(pair, Vec3d{0, 7, 0}, 10.0), 0);  // sliding past changes nothing
}

TEST(DensityDiffusion, SmoothsAndNeverSharpens) {
  const DensityDiffusion<double> diffusion{0.5, 0.0, {}};
  // 0.5 m (rho_i/rho_j - 1) F with rho_i/rho_j = 1.2/1.0
  EXPECT_NEAR(diffusion(pair, 0.2, 0.0, 10.0), 0.5 * 10 * 0.2 * -2, 1e-12);
  EXPECT_GT(diffusion(pair, 0.0, 0.2, 10.0), 0);
  EXPECT_EQ(diffusion(pair, 0.1, 0.1, 10.0), 0);
}

TEST(DensityDiffusion, LeavesTheGradientOfAFluidAtRestAlone) {
  const DensityDiffusion<double> diffusion{0.5, 0.0, {0, 0, -0.05}};
  EXPECT_NEAR(diffusion(pair, 0.0, 0.2, 10.0), 0, 1e-15);  // i is 4 m higher, 0.05 per m
}

TEST(StrainRate, IsTheSymmetrisedDyadOfVelocityAndGradient) {
  // -V F = 2 x 0.5 = 1: v (x) x + x (x) v with v = (1, 2, 0), x = (3, 0, 4)
  const Sym3<double> eps = strain_rate(pair, Vec3d{1, 2, 0}, 0.5);
  EXPECT_EQ(eps, (Sym3<double>{6, 6, 4, 0, 8, 0}));
}

TEST(StrainRate, SimpleShearHasTheEngineeringRate) {
  EXPECT_DOUBLE_EQ(shear_rate(Sym3<double>{0, 0, 3, 0, 0, 0}), 3);   // du/dz = 3
  EXPECT_DOUBLE_EQ(shear_rate(Sym3<double>{2, 0, 0, 0, 0, -2}), 2);  // pure shear, e = 1
}

TEST(StressForce, PressurePushesApartAndIsAntisymmetric) {
  const Sym3<double> s_i = isotropic(-3.0), s_j = isotropic(-1.0);
  EXPECT_EQ(stress_force(pair, s_i, s_j, 0.5), (Vec3d{12, 0, 16}));  // 0.5 x -2 x -4 x
  const PairGeometry<double> reversed{{-3, 0, -4}, 25, -2};
  EXPECT_EQ(stress_force(reversed, s_j, s_i, 0.5), (Vec3d{-12, 0, -16}));
}

TEST(StressForce, ShearStressPullsAlong) {
  const Sym3<double> s{0, 0, 1, 0, 0, 0};  // xz
  EXPECT_EQ(stress_force(pair, s, Sym3<double>{}, 1.0), (Vec3d{-8, 0, -6}));
}

TEST(PressurePower, IsTheVelocityTimesThePressureForce) {
  const Vec3d v{1, 2, -1};
  const Vec3d a = stress_force(pair, isotropic(-3.0), isotropic(-1.0), 0.5);
  EXPECT_DOUBLE_EQ(pressure_power(pair, v, 3.0, 1.0, 0.5), dot(v, a));
}

TEST(MorrisForce, OpposesTheVelocityDifference) {
  // 2 mu m/(rho rho) F r2/(r2 + 0) = 2 x 3 x 0.1 x -2
  const Vec3d a = morris_force(pair, Vec3d{1, -2, 0}, 3.0, 0.1, 0.0);
  EXPECT_NEAR(a.x, -1.2, 1e-15);
  EXPECT_NEAR(a.y, 2.4, 1e-15);
  EXPECT_EQ(a.z, 0);
}

TEST(PressureForce, IsTheStressForceOfAPressure) {
  EXPECT_EQ(pressure_force(pair, 3.0, 1.0, 0.5), (Vec3d{12, 0, 16}));  // -0.5 x -2 x 4 x
  EXPECT_EQ(pressure_force(pair, 3.0, 1.0, 0.5),
            stress_force(pair, isotropic(-3.0), isotropic(-1.0), 0.5));
}

TEST(ViscousConductance, IsTheMorrisForceOfBothParticles) {
  // 2 mu V_i V_j |F| = 2 x 3 x 0.02 x 2
  const double a = viscous_conductance(pair, 3.0, 0.1, 0.2);
  EXPECT_DOUBLE_EQ(a, 0.24);
  EXPECT_DOUBLE_EQ(viscous_conductance(pair, 3.0, 0.2, 0.1), a);
  // m_i a_i = -a_ij v_ij with masses rho V: rho_i = 1500, rho_j = 1200.
  const Vec3d v{1, -2, 0.5};
  const Vec3d force = 150.0 * morris_force(pair, v, 3.0, 240.0 / (1500 * 1200), 0.0);
  EXPECT_NEAR(norm(force + a * v), 0, 1e-14);
}

TEST(PairViscosity, IsTheHarmonicMean) {
  EXPECT_DOUBLE_EQ(pair_viscosity(2.0, 6.0), 3);
  EXPECT_EQ(pair_viscosity(0.0, 6.0), 0);
  EXPECT_EQ(pair_viscosity(0.0, 0.0), 0);
}

TEST(ArtificialForce, ActsOnApproachOnly) {
  EXPECT_EQ(artificial_viscosity(pair, Vec3d{1, 0, 0}, 5.0, 0.1, 0.0).acceleration,
            (Vec3d{0, 0, 0}));
  const auto closing = artificial_viscosity(pair, Vec3d{-1, 0, 0}, 5.0, 0.1, 0.0);
  const Vec3d a = closing.acceleration;
  // 5 x 0.1 x -2 x -3 / 25 = 0.12 along x_ij: apart
  EXPECT_NEAR(a.x, 0.36, 1e-15);
  EXPECT_NEAR(a.z, 0.48, 1e-15);
  // Both accelerations of the pair along its 3 m/s m of approach: 0.12 x 3, half of it each.
  EXPECT_NEAR(closing.heat, 0.18, 1e-15);
}

TEST(WallContact, HandsBackWhatClosesInOnIt) {
  EXPECT_DOUBLE_EQ(closing(pair, Vec3d{1, 0, 0}), pair.gradient * 3);
  EXPECT_DOUBLE_EQ(handed_back(0.5, Vec3d{}, 4.0, Vec3d{1, 2, 3}), 2);  // 0.5 x 4
}

// A flow that slides along a wall as one closes in on nothing: v_j = 2 m/s along x throughout, seen
// from a wall particle whose neighbours lie on one side only.
TEST(WallContact, HandsNothingBackToAFlowThatSlidesAsOne) {
  const Vec3d sliding{2, 0, 0}, normal{0, 0, 1};
  double rate = 0;
  Vec3d gradient;
  for (const Vec3d& x : {Vec3d{0.3, 0, -0.4}, Vec3d{0.5, 0.1, -0.4}, Vec3d{0.1, 0, -0.6}}) {
    const auto seen = pair_geometry(x, WendlandC2<double>::make(1, 3));
    rate += closing(seen, -1.0 * sliding);
    gradient += seen.gradient * seen.x;
  }
  EXPECT_GT(std::abs(rate), 1);
  EXPECT_NEAR(handed_back(0.5, along(sliding + Vec3d{0, 0, 7}, normal), rate, gradient), 0, 1e-14);
}

TEST(WallContact, DoesNotStretchWhatIsBelowTheReferenceDensity) {
  EXPECT_EQ(one_sided(-2.0, 0.01), -2);
  EXPECT_EQ(one_sided(2.0, -0.01), 2);
  EXPECT_EQ(one_sided(-2.0, -0.01), 0);
}

}  // namespace
}  // namespace sabo
