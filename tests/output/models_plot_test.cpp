#include "io/output/models_plot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"

namespace sabo {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(ModelsPlot, DrawsEveryLawWithoutAnOddNumber) {
  const ModelsPlot plot = plot_models(all_rheologies(), {0, 50, 100}, "a & b");
  for (const LineChart& chart : {plot.effective_viscosity, plot.shear_stress}) {
    const std::string svg = chart_svg(chart);
    for (const Rheology& law : all_rheologies())
      EXPECT_THAT(svg, HasSubstr(std::string(name_of(law)).append("</text>")));
    EXPECT_THAT(svg, HasSubstr("a &amp; b</text>"));
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_THAT(svg, Not(HasSubstr("inf")));
  }
  EXPECT_THAT(chart_svg(plot.shear_stress), HasSubstr(">yield stress</text>"));
}

TEST(ModelsPlot, NeedsALawButNoYieldStress) {
  EXPECT_THROW(plot_models({}, {0, 50, 0}, ""), CaseError);
  EXPECT_THAT(chart_svg(plot_models({Newtonian{20}}, {0, 0, 0}, "").shear_stress),
              Not(HasSubstr(">yield stress</text>")));
}

}  // namespace
}  // namespace sabo
