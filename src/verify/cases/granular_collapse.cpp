// Columns of grains on a level bed are let go: how far they run beside two sets of experiments, and
// the deposit beside that of a simulation grain by grain.
//
// What each reference is compared with: density 1500 kg/m3 (it matters for nothing), mu_B 0.1 Pa s,
// a thousandth of rho sqrt(g H0^3), mu_0/mu_B 1e5, so that creep over the collapse is some 1 %.
//   sand of Lube et al.: Mohr-Coulomb, 31 degrees
//   glass beads of Lajeunesse et al.: Mohr-Coulomb, 22 degrees, and mu(I)
//   contact dynamics: mu(I) with the constants that Lagrée et al. fitted to it, mu_s 0.32, mu_2
//   0.60, I_0 0.4, H0 29.8 grains; and Mohr-Coulomb with 20 degrees, which is that mu(I) at I =
//   0.07

#include <array>
#include <cmath>

#include "verify/cases.hpp"
#include "verify/cases/column_collapse.hpp"
#include <fmt/format.h>

#include "math/angle.hpp"

namespace sabo {
namespace {

constexpr double rho = 1500, g = 9.81, half_width = 0.1;  // L0, m

// (L - L0)/L0 of columns between two plates.

/// Lube, Huppert, Sparks & Freundt 2005. The branches do not meet where one takes over.
double lube(double a) { return a < 2.3 ? 1.2 * a : 1.9 * std::pow(a, 2.0 / 3); }
/// Lajeunesse, Monnier & Homsy 2005.
double lajeunesse(double a) { return a < 3 ? 1.8 * a : 2.3 * std::pow(a, 2.0 / 3); }

/// Deposit at a = 0.5 by contact dynamics (Lagrée, Staron & Popinet 2011, as published with
/// Basilisk), mean of both sides: height over H0 at 0, 0.1, 0.2, ... H0 from the middle.
constexpr std::array<double, 41> contact_dynamics{
    0.961, 0.966, 0.984, 0.974, 0.958, 0.940, 0.919, 0.871, 0.828, 0.800, 0.767,
    0.731, 0.692, 0.673, 0.621, 0.607, 0.586, 0.570, 0.521, 0.510, 0.471, 0.425,
    0.402, 0.388, 0.347, 0.337, 0.333, 0.293, 0.270, 0.257, 0.228, 0.207, 0.191,
    0.172, 0.134, 0.092, 0.086, 0.048, 0.063, 0.030, 0.000};
constexpr double contact_dynamics_runout = 0.94;

MaterialCase coulomb(double friction_angle) {
  MaterialCase material;
  material.density = rho;
  material.law = Cross{0.1, 1e5, 1};
  material.yield = {0, friction_angle, 0};
  return material;
}

/// mu(I) of grains: static friction, its growth, I_0, diameter in m.
MaterialCase mu_i(double friction, double increase, double i_0, double diameter) {
  MaterialCase material = coulomb(std::atan(friction) / degree);
  MuI law;
  law.increase = increase;
  law.i_0 = i_0;
  law.diameter = diameter;
  law.grain_density = rho;
  law.eta = 0.1;
  law.cap = 1e4;
  material.law = law;
  return material;
}

/// Those of the contact dynamics, fitted by Lagrée et al. 2011.
MaterialCase discs(double height) { return mu_i(0.32, 0.28, 0.4, height / 29.8); }

/// Glass beads (Jop, Forterre & Pouliquen 2006) of 1.15 mm, L0/87.
const MaterialCase glass_beads = mu_i(0.382, 0.261, 0.279, 1.15e-3);

struct Deposit {
  double runout = 0;     ///< (L - L0)/L0
  double height = 0;     ///< of the middle tenth of L0, over H0
  double growth = 0;     ///< of the run-out in the last fifth of the time
  double imbalance = 0;  ///< greatest of energy over that released, by size
  ChartSeries profile;   ///< over H0
};

constexpr int starts = 3;  // the foot of a single deposit scatters by some 5 %

/// After 10 sqrt(H0/g); the mass has run by 4 of them.
Deposit collapse(double a, const MaterialCase& material, double spacing, int start,
                 const VerifySettings& settings) {
  const double h0 = a * half_width;
  NumericsCase numerics = settings.numerics();
  numerics.spacing = spacing;
  const double reach = half_width * (1.5 + 2 * lajeunesse(a));
  ColumnCollapse mass({half_width, h0, spacing * std::round(reach / spacing)},
                      settings.model(material, numerics, h0), numerics,
                      static_cast<std::uint64_t>(start));
  const double time = std::sqrt(h0 / g);
  mass.run_to(8 * time);
  const double before = mass.half_length();
  mass.run_to(10 * time);
  Deposit deposit;
  deposit.runout = mass.half_length() / half_width - 1;
  deposit.growth = (mass.half_length() - before) / half_width;
  deposit.height = mass.height(0, half_width / 10) / h0;
  deposit.imbalance = std::abs(mass.energy_imbalance());
  deposit.profile = mass.profile(mass.half_length() + 0.1 * h0, 0.1 * h0);
  for (double& x : deposit.profile.x) x /= h0;
  for (double& y : deposit.profile.y) y /= h0;
  return deposit;
}

/// Mean of several starts.
Deposit mean_collapse(double a, const MaterialCase& material, double spacing, int count,
                      const VerifySettings& settings) {
  Deposit mean;
  for (int start = 1; start <= count; ++start) {
    const Deposit one = collapse(a, material, spacing, start, settings);
    mean.runout += one.runout / count;
    mean.height += one.height / count;
    mean.growth += one.growth / count;
    mean.imbalance = std::max(mean.imbalance, one.imbalance);
    auto& [name, x, y, has_markers, has_line] = mean.profile;
    if (one.profile.x.size() > x.size()) {
      x = one.profile.x;
      y.resize(x.size(), 0);
    }
    for (std::size_t k = 0; k < one.profile.y.size(); ++k) y[k] += one.profile.y[k] / count;
  }
  return mean;
}

/// Root mean square of the difference to contact dynamics over the length of either, over H0.
double difference(const ChartSeries& profile) {
  double sum = 0;
  std::size_t bins = 0;
  const auto reference = [](std::size_t k) {
    return k < contact_dynamics.size() ? contact_dynamics[k] : 0;
  };
  for (std::size_t k = 0; k < std::max(profile.y.size(), contact_dynamics.size()); ++k, ++bins) {
    const double here = k < profile.y.size() ? profile.y[k] : 0;
    const double there = (reference(k) + reference(k + 1)) / 2;
    sum += (here - there) * (here - there);
  }
  return std::sqrt(sum / static_cast<double>(bins));
}

struct Sample {
  std::string name;
  MaterialCase material;
  Claim (*claim)(std::string what, double runout, double low, double high);
};

/// What each material should do beside the laws of Lube et al. and of Lajeunesse et al.
std::vector<Sample> samples(bool is_quick) {
  const auto between = [](std::string what, double runout, double low, double high) {
    return Claim::within(what + ", between the laws", "", runout, (low + high) / 2,
                         (high - low) / 2);
  };
  const auto beside = [](std::string what, double runout, double, double high) {
    return Claim::told(what + ", beside Lajeunesse et al.", "", runout, high);
  };
  const auto below = [](std::string what, double runout, double low, double) {
    return Claim::at_most(what + ", short of both laws", "", runout, low);
  };
  std::vector<Sample> list{{"31°", coulomb(31), between}, {"45°", coulomb(45), below}};
  if (is_quick) return {list.front()};
  list.push_back({"22°", coulomb(22), beside});
  list.push_back({"μ(I) of glass", glass_beads, beside});
  return list;
}

void compare_runouts(bool is_quick, const VerifySettings& settings, Verdict& verdict,
                     const std::function<void(double)>& on_share) {
  LineChart chart{fmt::format("Run-out of columns, mean of {} starts", starts), "H0/L0",
                  "(L − L0)/L0"};
  chart.x_log = chart.y_log = true;
  ChartSeries low{"Lube et al. 2005"}, high{"Lajeunesse et al. 2005"};
  for (double a = 0.4; a < 5; a *= 1.05) {
    low.x.push_back(a);
    low.y.push_back(lube(a));
    high.x.push_back(a);
    high.y.push_back(lajeunesse(a));
  }
  chart.series = {low, high};
  const std::vector<double> aspects = is_quick ? std::vector{1.0} : std::vector{0.5, 1.0, 2.0, 4.0};
  const std::vector<Sample> list = samples(is_quick);
  for (const Sample& sample : list) {
    ChartSeries found{sample.name, {}, {}, true, false};
    double imbalance = 0;
    for (const double a : aspects) {
      const double spacing = half_width * std::min(1.0, a) / 20;
      found.x.push_back(a);
      const Deposit deposit = mean_collapse(a, sample.material, spacing, starts, settings);
      found.y.push_back(deposit.runout);
      imbalance = std::max(imbalance, deposit.imbalance);
      verdict.claims.push_back(sample.claim(
          fmt::format("a {:g}, {}, L0/dp {:.0f}: run-out", a, sample.name, half_width / spacing),
          found.y.back(), lube(a), lajeunesse(a)));
      on_share(1.0 / static_cast<double>(list.size() * aspects.size()));
    }
    verdict.claims.push_back(
        claim_of_books(fmt::format("{}, the worst of its columns: ", sample.name), imbalance));
    chart.series.push_back(std::move(found));
  }
  verdict.charts.push_back(std::move(chart));
}

void compare_deposits(bool is_quick, const VerifySettings& settings, Verdict& verdict,
                      const std::function<void(double)>& on_share) {
  const double h0 = 0.5 * half_width;
  const int cells = is_quick ? 20 : 40;
  LineChart chart{fmt::format("Deposit of a column with H0/L0 = 0.5, H0/dp {}", cells),
                  "distance from the middle over H0", "height over H0"};
  for (const bool is_mu_i : is_quick ? std::vector{true} : std::vector{true, false}) {
    const Deposit deposit = mean_collapse(0.5, is_mu_i ? discs(h0) : coulomb(20), h0 / cells,
                                          is_quick ? 1 : starts, settings);
    const std::string name =
        fmt::format("contact dynamics, {}, H0/dp {}: ", is_mu_i ? "μ(I)" : "20°", cells);
    verdict.claims.push_back(
        Claim::at_most(name + "root mean square difference of profiles over H0", "",
                       difference(deposit.profile), 0.05));
    verdict.claims.push_back(Claim::within_share(name + "height over H0", "", deposit.height,
                                                 contact_dynamics.front(), 0.03));
    verdict.claims.push_back(
        is_mu_i ? Claim::within_share(name + "run-out", "", deposit.runout, contact_dynamics_runout,
                                      0.1)
                : Claim::told(name + "run-out", "", deposit.runout, contact_dynamics_runout));
    verdict.claims.push_back(Claim::at_most(name + "growth of the run-out from 8 to 10 √(H0/g)", "",
                                            deposit.growth, 0.01));
    chart.series.push_back(deposit.profile);
    chart.series.back().name = is_mu_i ? "μ(I)" : "20°";
    on_share(is_quick ? 1 : 0.5);
  }
  ChartSeries reference{"contact dynamics", {}, {}, true, false};
  for (std::size_t k = 0; k < contact_dynamics.size(); ++k) {
    reference.x.push_back(0.1 * static_cast<double>(k));
    reference.y.push_back(contact_dynamics[k]);
  }
  chart.series.push_back(std::move(reference));
  verdict.charts.push_back(std::move(chart));
}

}  // namespace

Verdict verify_granular_collapse(const VerifySettings& settings) {
  const bool is_quick = settings.is_quick();
  Verdict verdict;
  double done = 0;
  const auto on_share = [&](double weight) {
    return [&, weight](double share) { settings.on_progress(done += weight * share); };
  };
  compare_runouts(is_quick, settings, verdict, on_share(0.6));
  compare_deposits(is_quick, settings, verdict, on_share(0.4));
  if (!is_quick)
    verdict.remarks = {
        fmt::format("L0 {:g} m; ρ {:g} kg/m³, which matters for nothing; μB 0.1 Pa s, about a "
                    "thousandth of ρ √(g H0³), μ0/μB 1e5, so that creep over the collapse is some "
                    "1 %. Sand of Lube et al.: 31°. Glass beads of Lajeunesse et al.: 22°, and "
                    "μ(I) of 0.382, 0.643, I0 0.279, grains of L0/87. Contact dynamics: μ(I) of "
                    "0.32, 0.60, I0 0.4, H0 of 29.8 grains, as fitted by Lagrée et al.; and 20°, "
                    "which is that μ(I) at I = 0.07",
                    half_width, rho),
        "Tall columns of 22° run too far, beyond the law for glass beads from a = 1 on: a plane of "
        "constant friction has neither the growth of friction with the rate, which takes a tenth "
        "off in the μ(I) of glass, nor the side walls of the channel, which no run has",
        "The lowest column of 31° ends 1.5 % before the law of Lube et al., which is the lower end "
        "of the band. With L0/dp 80 its run-out is 0.612, and 0.610 where density is not held to "
        "the places of the particles (docs/method.md, F9), which takes pressure from outer rows "
        "that a front draws apart, the more of it the coarser they are"};
  settings.on_progress(1);
  return verdict;
}

}  // namespace sabo
