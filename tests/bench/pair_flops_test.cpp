#include "bench/pair_flops.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "physics/pair/density.hpp"
#include "physics/pair/forces.hpp"
#include "physics/pair/strain_rate.hpp"
#include "physics/pair/viscous_flux.hpp"

namespace sabo {
namespace {

/// A number that counts what is done with it, for the formulas in src/physics.
struct Counted {
  double value = 0;
  static inline int operations = 0;

  Counted() = default;
  explicit Counted(double v) : value(v) {}
  Counted& operator+=(const Counted& b) { return *this = *this + b; }
  Counted& operator-=(const Counted& b) { return *this = *this - b; }
  Counted& operator*=(const Counted& b) { return *this = *this * b; }

  static Counted result(double v) {
    ++operations;
    return Counted(v);
  }
  friend Counted operator+(Counted a, Counted b) { return result(a.value + b.value); }
  friend Counted operator-(Counted a, Counted b) { return result(a.value - b.value); }
  friend Counted operator*(Counted a, Counted b) { return result(a.value * b.value); }
  friend Counted operator/(Counted a, Counted b) { return result(a.value / b.value); }
  friend Counted operator-(Counted a) { return Counted(-a.value); }
  friend Counted sqrt(Counted a) { return result(std::sqrt(a.value)); }
  /// A choice, as a change of sign.
  friend Counted positive(Counted a) { return Counted(a.value > 0 ? 1 : 0); }
  friend Counted larger(Counted a, Counted b) { return result(std::max(a.value, b.value)); }
};

template <class F>
int operations_of(const F& f) {
  Counted::operations = 0;
  f();
  return Counted::operations;
}

const Counted one(1);
const Vec3<Counted> vector{one, one, one};
const Sym3<Counted> tensor{one, one, one, one, one, one};
const WendlandC2<Counted> kernel{one, one};

constexpr int separation = 3;  // one product by the unit of length each
/// -20 alpha half half and half = 0.5 / h, which the compiler takes out of the loop.
constexpr int kernel_constants = 4;

TEST(PairFlops, OfTheMotionSweepAreThoseOfItsFormulas) {
  const DensityDiffusion<Counted> diffusion{one, one, vector};
  const int formulas = operations_of([&] {
    const auto pair = pair_geometry(vector, kernel);
    const Vec3<Counted> v = vector - vector;
    const Counted mass = one * (one + one * one);  // volume (rho0 + rho0 excess)
    Counted rate(0);
    Sym3<Counted> eps = tensor;
    rate += continuity(pair, v, mass);
    rate += diffusion(pair, one, one, mass);
    eps += strain_rate(pair, one * v, one);
  });
  EXPECT_EQ(flops_of_pair("motion sweep"), separation + formulas - kernel_constants);
}

TEST(PairFlops, OfTheForceSweepAreThoseOfItsFormulas) {
  const int formulas = operations_of([&] {
    const auto pair = pair_geometry(vector, kernel);
    Vec3<Counted> acceleration = vector;
    Counted power(0);
    acceleration += stress_force(pair, tensor, tensor, one);
    power += pressure_power(pair, vector, one, one, one);
  });
  EXPECT_EQ(flops_of_pair("force sweep"), separation + formulas - kernel_constants);
}

TEST(PairFlops, OfTheWallPressureAreThoseOfItsFormulas) {
  const int formulas = operations_of([&] {
    const Counted r2 = dot(vector, vector);
    const Counted w = kernel.value(sqrt(r2)) * positive(r2);
    Counted weight(0), pressure(0);
    weight += w;
    pressure += w * one * (one * one + dot(vector, vector));
  });
  EXPECT_EQ(flops_of_pair("wall pressure"), separation + formulas);
}

TEST(PairFlops, OfForceAndMatrixAreThoseOfItsFormulas) {
  constexpr int shared_root = 1, twice_my_viscosity = 1;
  const int formulas = operations_of([&] {
    const auto pair = pair_geometry(vector, kernel);
    Vec3<Counted> acceleration = vector, gradient = vector;
    Counted conductance(0), filling(0);
    acceleration += pressure_force(pair, one, one, one);
    const Counted a = viscous_conductance(pair, pair_viscosity(one, one), one, one);
    conductance += a;
    Sym3<Counted> moments = tensor;
    moments += scaled_square(a, pair.x);
    filling += one * kernel.value(sqrt(pair.r2)) * positive(pair.r2);
    gradient += (one * pair.gradient) * pair.x;
    const Counted is_near = pair.gradient * pair.r2;
    EXPECT_LT(is_near.value, 1e9);
  });
  EXPECT_EQ(flops_of_pair("force and matrix"),
            separation + formulas - kernel_constants - shared_root - twice_my_viscosity);
}

TEST(PairFlops, OfNearMotionAreThoseOfItsFormulas) {
  const DensityDiffusion<Counted> diffusion{one, one, vector};
  const int formulas = operations_of([&] {
    const auto pair = pair_geometry(vector, kernel);
    const Vec3<Counted> v = vector - vector;
    const Counted mass = one * (one + one * one);  // volume (rho0 + rho0 excess)
    Counted rate(0), support(0);
    Sym3<Counted> eps = tensor;
    rate += continuity(pair, v, mass) + diffusion(pair, one, one, mass);
    eps += strain_rate(pair, v, one);
    support += one * pair.gradient * pair.r2;
  });
  EXPECT_EQ(flops_of_pair("near motion"), separation + formulas - kernel_constants);
}

TEST(PairFlops, OfShiftingAreThoseOfItsFormulas) {
  const int formulas = operations_of([&] {
    const auto pair = pair_geometry(vector, kernel);
    Counted near(0);
    near += continuity(pair, vector, one);
  });
  EXPECT_EQ(flops_of_pair("shifting"), separation + formulas - kernel_constants);
}

TEST(PairFlops, OfTheViscousSolveAreThoseOfBothSweepsOfAProduct) {
  const int formulas = operations_of([&] {
    VelocityGradient<Counted> gradient;
    gradient += outer_product(vector - vector, one * vector);
    Vec3<Counted> flow = vector, weighted = vector;
    flow += one * (vector - vector + transposed_times(gradient, vector));
    weighted += one * vector;
  });
  EXPECT_EQ(flops_of_pair("viscous solve"), 2 * separation + formulas);
}

TEST(PairFlops, AreZeroForAPassThatNobodyCounted) {
  EXPECT_EQ(flops_of_pair("neighbour search"), 0);
}

}  // namespace
}  // namespace sabo
