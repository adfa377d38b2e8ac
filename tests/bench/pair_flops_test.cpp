#include "bench/pair_flops.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "physics/pair/density.hpp"
#include "physics/pair/forces.hpp"
#include "physics/pair/strain_rate.hpp"

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

TEST(PairFlops, AreZeroForAPassThatNobodyCounted) {
  EXPECT_EQ(flops_of_pair("neighbour search"), 0);
}

}  // namespace
}  // namespace sabo
