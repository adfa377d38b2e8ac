#include "io/output/models_plot.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"

namespace sabo {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(ModelsPlot, DrawsEveryLawWithoutAnOddNumber) {
  const ModelsPlot plot = plot_models(all_rheologies(), {0, 50, 100}, "a & b");
  for (const std::string& svg : {plot.effective_viscosity, plot.shear_stress}) {
    for (const Rheology& law : all_rheologies())
      EXPECT_THAT(svg, HasSubstr(std::string(name_of(law)).append("</text>")));
    EXPECT_THAT(svg, HasSubstr("a &amp; b</text>"));
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_THAT(svg, Not(HasSubstr("inf")));
  }
  EXPECT_THAT(plot.shear_stress, HasSubstr(">yield stress</text>"));
}

TEST(ModelsPlot, NeedsALawButNoYieldStress) {
  EXPECT_THROW(plot_models({}, {0, 50, 0}, ""), CaseError);
  EXPECT_THAT(plot_models({Newtonian{20}}, {0, 0, 0}, "").shear_stress,
              Not(HasSubstr(">yield stress</text>")));
}

/// Figure 1 of the paper of 2016: of the laws that stand in for Bingham's, Cross's is the nearest
/// to it (numbers of the figure, mu_B = 20 Pa s and tau_B = 50 Pa; the defaults of each law).
TEST(ModelsPlot, CrossIsNearestToBingham) {
  const Rheology stand_ins[] = {Cross{20, 1000, 1}, FrigaardNouar{{20, 1000}},
                                Threshold{{20, 1000}}, Papanastasiou{{20, 1000}}};
  std::vector<double> farthest;
  for (const Rheology& law : stand_ins) {
    double far = 0;
    for (double gd = 1e-4; gd < 1e3; gd *= 1.1) {
      const double exact = 20 + 50 / gd;
      const double mu = std::visit([&](const auto& l) { return l.viscosity({gd, 50, 0}); }, law);
      far = std::max(far, std::abs(std::log(mu / exact)));
    }
    farthest.push_back(far);
  }
  for (std::size_t k = 1; k < farthest.size(); ++k) EXPECT_LT(farthest[0], farthest[k]);
}

}  // namespace
}  // namespace sabo
