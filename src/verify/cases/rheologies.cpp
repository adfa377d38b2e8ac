// Figure 1 of the paper of 2016: Bingham's fluid and the laws that stand in for it, with its
// numbers. How near a law comes is a matter of its own parameters as well, so both are told: with
// the defaults of each law, and all with the same viscosity at rest.

#include <cmath>

#include "verify/cases.hpp"

#include "io/output/models_plot.hpp"

namespace sabo {
namespace {

constexpr double mu_b = 20, yield_stress = 50;  // Pa s, Pa
constexpr double ratio = 1000;                  // mu_0 over mu_B, of the paper

/// Root mean square of the stress over that of the exact fluid, less 1, over shear rates from 1e-4
/// to 1e3 1/s, evenly by their logarithm.
double distance(const Rheology& law) {
  constexpr int points = 700;
  double sum = 0;
  for (int k = 0; k <= points; ++k) {
    const double rate = std::pow(10, -4 + 7.0 * k / points);
    const double mu = std::visit(
        [&](const auto& l) {
          return l.viscosity({rate, yield_stress, 0});
        },
        law);
    const double difference = mu * rate / (yield_stress + mu_b * rate) - 1;
    sum += difference * difference / (points + 1);
  }
  return std::sqrt(sum);
}

}  // namespace

Verdict verify_rheologies(const VerifySettings& settings) {
  const Rheology exact = Bingham{{mu_b, 1e6}};  // its cap is out of sight
  const Rheology cross = Cross{mu_b, ratio, 1};
  const Plastic plastic{mu_b, ratio};
  const std::vector<Rheology> others{FrigaardNouar{plastic}, Threshold{plastic},
                                     Papanastasiou{plastic}};
  const double transition = yield_stress / (mu_b * ratio);  // 1/s, where Cross has half the stress
  const std::vector<Rheology> as_stiff{FrigaardNouar{plastic, transition},
                                       Threshold{plastic, transition},
                                       Papanastasiou{plastic, 1 / transition}};
  Verdict verdict;
  for (const Rheology& law : others)
    verdict.claims.push_back(
        Claim::at_most("distance to Bingham: Cross over " + std::string(name_of(law)), "",
                       distance(cross) / distance(law), 1));
  for (const Rheology& law : as_stiff)
    verdict.claims.push_back(
        Claim::told(std::string(name_of(law)) + ", viscosity at rest of Cross: distance to Bingham",
                    "", distance(law), distance(cross)));
  std::vector<Rheology> drawn{exact, cross};
  drawn.insert(drawn.end(), others.begin(), others.end());
  ModelsPlot plot = plot_models(drawn, {0, yield_stress, 0}, "μB = 20 Pa s, τB = 50 Pa");
  verdict.charts = {std::move(plot.effective_viscosity), std::move(plot.shear_stress)};
  verdict.remarks.push_back(
      "Cross with μ0/μB 1000, as in the paper, the others with the defaults of this program; with "
      "the same viscosity at rest the order is another, and Cross is Frigaard and Nouar's law");
  settings.on_progress(1);
  return verdict;
}

}  // namespace sabo
