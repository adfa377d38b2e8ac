#include <cmath>
#include <variant>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "physics/rheology_list.hpp"

namespace sabo {
namespace {

// Expected values as a table: law, shear rate (1/s), yield stress (Pa), viscosity (Pa s), source.
struct Row {
  const char* name;
  Rheology law;
  double shear_rate;
  double yield_stress;
  double viscosity;
};

// mu_B = 20 Pa s and tau_B = 50 Pa are those of the paper's figure 1; ratio 1000 gives mu_0 =
// 20000.
const Row table[] = {
    {"newtonian ignores shear and yield", Newtonian{7}, 3, 50, 7},
    {"bingham: 20 + 50/10", Bingham{20, 1000}, 10, 50, 25},
    {"bingham at rest is the cap", Bingham{20, 1000}, 0, 50, 20000},
    {"bingham below the cap's shear rate", Bingham{20, 1000}, 1e-3, 50, 20000},
    {"bingham without yield is newtonian", Bingham{20, 1000}, 0, 0, 20},
    {"cross at rest is mu_0", Cross{20, 1000, 1}, 0, 50, 20000},
    {"cross at mu_0 gd = tau_B is the mean", Cross{20, 1000, 1}, 50.0 / 20000, 50, 10010},
    {"cross: (20000 + 4000 x 20) / 4001, K = 400, gd = 10", Cross{20, 1000, 1}, 10, 50,
     100000.0 / 4001},
    {"cross without yield is mu_inf", Cross{20, 1000, 1}, 10, 0, 20},
    {"cross at rest without yield is mu_inf", Cross{20, 1000, 1}, 0, 0, 20},
    {"cross m = 2: K gd = 2, 20 + 19980/5", Cross{20, 1000, 2}, 2.0 / 400, 50, 4016},
    {"general cross at rest", GeneralCross{20000, 20, 400, 1}, 0, 0, 20000},
    {"general cross, same as cross", GeneralCross{20000, 20, 400, 1}, 10, 0, 100000.0 / 4001},
    {"general cross m = 0.5: K gd = 4, 20 + 19980/3", GeneralCross{20000, 20, 400, 0.5}, 0.01, 0,
     6680},
};

TEST(Rheology, MatchesTheTable) {
  for (const Row& row : table) {
    const double mu = std::visit(
        [&](const auto& law) { return law.viscosity(row.shear_rate, row.yield_stress); }, row.law);
    EXPECT_NEAR(mu, row.viscosity, 1e-9 * row.viscosity) << row.name;
  }
}

TEST(Rheology, FastFlowApproachesTheBinghamStress) {
  const Cross cross{20, 1000, 1};
  const double gd = 1e4;
  // tau = mu_inf gd + (1 - mu_inf/mu_0) tau_B for K gd >> 1: Eq. 22 multiplied out.
  EXPECT_NEAR(cross.viscosity(gd, 50) * gd, 20 * gd + 0.999 * 50, 0.01);
}

/// 1e-8 .. 1e4, the twelve decades a flow can show.
rc::Gen<double> shear_rates() {
  return rc::gen::map(rc::gen::inRange(-8000, 4000), [](int k) { return std::pow(10, k / 1e3); });
}

RC_GTEST_PROP(Rheology, StressNeverFallsWithShearRateAndViscosityStaysInBounds, ()) {
  const Rheology laws[] = {Newtonian{7}, Bingham{20, 1000}, Cross{20, 1000, 1},
                           GeneralCross{20000, 20, 400, 1}};
  const double gd = *shear_rates();
  const double yield_stress = *rc::gen::element(0.0, 1e-6, 50.0, 1e6);
  for (const Rheology& law : laws) {
    std::visit(
        [&](const auto& l) {
          const double mu = l.viscosity(gd, yield_stress);
          RC_ASSERT(std::isfinite(mu));
          RC_ASSERT(mu > 0);
          RC_ASSERT(mu <= l.max_viscosity() * (1 + 1e-12));
          const double faster = 1.01 * gd;
          RC_ASSERT(l.viscosity(faster, yield_stress) * faster >= mu * gd);
        },
        law);
  }
}

}  // namespace
}  // namespace sabo
