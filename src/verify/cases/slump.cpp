// A square column of a Bingham fluid slumps on a level bed, slowly enough for its inertia not to
// matter, until its yield stress carries it.
//
// The Cross fluid that stands in for it never stops entirely. Approach to rest by viscosity takes
// the time T = mu_B / (rho g H0) times a number, creep changes the shape by about (mu_B / mu_0) of
// that number: with mu_0 / mu_B = 1e5 there is a long time at which one is over and the other has
// not begun. It counts as stopped when doubling the time changes its length by less than 3 %.

#include "verify/cases.hpp"
#include "verify/cases/column_collapse.hpp"
#include "verify/slump_at_rest.hpp"
#include <fmt/format.h>

namespace sabo {
namespace {

constexpr double rho = 1000, g = 9.81, side = 0.1;  // H0 = L0, m
constexpr double half_volume = side * side;         // of half the column, m2

struct Slump {
  double bingham;    ///< B = tau_y / (rho g H0)
  double viscosity;  ///< mu_B, Pa s
  double ratio;      ///< mu_0 over mu_B
  double reach;      ///< of the bed, m
  double share = 1;  ///< of the yield stress that the material has
  bool sleeps = false;
};

ColumnCollapse column(const Slump& slump, int cells, const VerifySettings& settings) {
  NumericsCase numerics = settings.numerics();
  numerics.spacing = side / cells;
  // The limit for sleep is meant for flows of metres a second; this one moves by centimetres.
  if (!slump.sleeps) numerics.sleep_speed = 0;
  MaterialCase material;
  material.density = rho;
  material.law = Cross{slump.viscosity, slump.ratio, 1};
  material.yield = {slump.share * slump.bingham * rho * g * side, 0, 0};
  return ColumnCollapse({side, side, slump.reach}, settings.model(material, numerics, side),
                        numerics);
}

struct Outcome {
  double length = 0, toe = 0, centre = 0;  ///< m
  double doubling = 0;                     ///< change of the length over the last half of the time
  double imbalance = 0;                    ///< of energy
  ChartSeries profile;
};

/// Lengths at the end and at half the time. The centre is the middle quarter.
Outcome outcome(const Slump& slump, int cells, double end, const VerifySettings& settings,
                const std::function<void(double)>& on_share) {
  ColumnCollapse mass = column(slump, cells, settings);
  const SlumpAtRest rest{slump.bingham * side};
  const double bin = side / 20;
  const auto length = [&] { return mass.half_length_at(rest.front(), bin); };
  Outcome result;
  double half = 0;
  constexpr int parts = 40;
  for (int k = 1; k <= parts; ++k) {
    mass.run_to(end * k / parts);
    if (k == parts / 2) half = length();
    on_share(1.0 / parts);
  }
  result.length = length();
  result.toe = mass.half_length();
  result.doubling = result.length / half - 1;
  result.centre = mass.height(0, side / 4);
  result.profile = mass.profile(result.toe + bin, bin);
  result.imbalance = mass.energy_imbalance();
  return result;
}

double mean_height(const SlumpAtRest& rest, double from, double to) {
  const double length = rest.length(half_volume);
  double sum = 0;
  for (int k = 0; k < 100; ++k) sum += rest.height(length - from - (k + 0.5) / 100 * (to - from));
  return sum / 100;
}

/// How far the top of the column with B = 0.4 sinks in a second, m, once its pressure has settled.
double sinking(bool sleeps, int cells, const VerifySettings& settings) {
  ColumnCollapse mass = column({0.4, 100, 1e4, 2 * side, 1, sleeps}, cells, settings);
  const auto top = [&] {
    double z = 0;
    for (const Vec3d& p : mass.fluid().position) z = std::max(z, p.z);
    return z;
  };
  mass.run_to(2);
  const double before = top();
  mass.run_to(3);
  return before - top();
}

ChartSeries reference(const SlumpAtRest& rest) {
  ChartSeries series{"at rest", {}, {}};
  const double length = rest.length(half_volume);
  constexpr int points = 25;
  for (int k = 0; k <= points; ++k) {
    series.x.push_back(length * k / points);
    series.y.push_back(rest.height(length - series.x.back()));
  }
  series.has_markers = true;
  series.has_line = false;
  return series;
}

}  // namespace

Verdict verify_slump(const VerifySettings& settings) {
  const bool is_quick = settings.is_quick();
  const int fine = is_quick ? 10 : 40, coarse = is_quick ? 10 : 20;
  // Shares of the work by what it takes: B 0.05, 0.01, the others at the coarse spacing.
  double done = 0;
  const auto on_share = [&](double weight) {
    return [&, weight](double share) { settings.on_progress(done += weight * share); };
  };
  Verdict verdict;
  const std::string at = fmt::format("H0/dp {}", fine);
  std::vector<std::pair<Slump, double>> runs{{{0.05, 10, 1e5, 0.4}, is_quick ? 10.0 : 20.0}};
  if (!is_quick) runs.push_back({{0.01, 3, 1e5, 0.65}, 32});
  double length_of_first = 0;
  for (const auto& [slump, end] : runs) {
    const SlumpAtRest rest{slump.bingham * side};
    const Outcome found = outcome(slump, fine, end, settings, on_share(is_quick ? 0.45 : 0.35));
    if (length_of_first == 0) length_of_first = found.length;
    const std::string name = fmt::format("B {:g}, {}", slump.bingham, at);
    verdict.claims.push_back(Claim::within_share(name + ": L, where the height is πb", "m",
                                                 found.length, rest.length(half_volume), 0.07));
    verdict.claims.push_back(Claim::within_share(name + ": mean height of the middle quarter", "m",
                                                 found.centre, mean_height(rest, 0, side / 4),
                                                 0.07));
    verdict.claims.push_back(Claim::at_most(name + ": growth of L in the second half of the time",
                                            "", found.doubling, 0.03));
    verdict.claims.push_back(
        Claim::told(name + ": the foremost particle", "m", found.toe, rest.length(half_volume)));
    verdict.claims.push_back(claim_of_books(name + ": ", found.imbalance));
    LineChart chart{fmt::format("Slump of a square column, B = {:g}", slump.bingham),
                    "distance from the middle [m]", "height [m]"};
    chart.series = {found.profile, reference(rest)};
    chart.series[0].name = at;
    verdict.charts.push_back(std::move(chart));
  }

  const double expected = SlumpAtRest{0.05 * side}.length(half_volume);
  const double rest_weight = is_quick ? 0.45 : 0.1;
  const Outcome weak = outcome({0.05, 10, 1e5, 0.5, 0.5}, coarse, is_quick ? 10 : 20, settings,
                               on_share(rest_weight));
  verdict.claims.push_back(
      Claim::at_least(fmt::format("half the yield stress, H0/dp {}: L over that of B 0.05", coarse),
                      "", weak.length / expected, 1.07));
  if (!is_quick) {
    const Outcome slow = outcome({0.05, 30, 1e5, 0.4}, coarse, 60, settings, on_share(rest_weight));
    verdict.claims.push_back(
        Claim::within_share("B 0.05, three times the viscosity and the time, H0/dp 20: L", "m",
                            slow.length, length_of_first, 0.03));
    const Outcome asleep =
        outcome({0.05, 10, 1e5, 0.4, 1, true}, coarse, 20, settings, on_share(0.05));
    verdict.claims.push_back(Claim::within_share("B 0.05, deposits may sleep, H0/dp 20: L", "m",
                                                 asleep.length, expected, 0.07));
  }
  const double creep = rho * g * side * side / (8 * 100 * 1e4);
  const std::string sinks =
      fmt::format("B 0.4, H0/dp {}: sinks in 1 s, beside ρ g H0²/(8 μ0) of a free column", coarse);
  verdict.claims.push_back(
      Claim::at_most(sinks + ", deposits may sleep", "m", sinking(true, coarse, settings), creep));
  if (!is_quick) {
    verdict.claims.push_back(
        Claim::at_most(sinks + ", none may sleep", "m", sinking(false, coarse, settings), creep));
    verdict.remarks = {
        fmt::format("ρ {:g} kg/m³, H0 = L0 = {:g} m, μ0/μB 1e5; μB 10 Pa s with B 0.05, 3 Pa s "
                    "with B 0.01, so that the Reynolds number is small; with B 0.4 μB 100 Pa s, "
                    "μ0/μB 1e4. Default walls, to which the fluid sticks",
                    rho, side),
        "The solution ends in an upright front of height πb; the simulated one leans: its foot is "
        "farther out than L",
        "Where none may sleep the column with B 0.4 sinks at a speed that does not fall with μ0: "
        "particles at its free sides tremble, and the shear rate of that keeps the viscosity "
        "below μ0. Asleep it is at rest."};
  }
  settings.on_progress(1);
  return verdict;
}

}  // namespace sabo
