// A slab 3.75 m thick of a Cross fluid with friction starts from rest on an infinite slope: with
// 33 degrees it runs, with 16 degrees, below its friction angle of 28, it only creeps.

#include <cmath>
#include <optional>

#include "verify/cases.hpp"
#include "verify/slab_solution.hpp"
#include <fmt/format.h>

#include "math/angle.hpp"
#include "solver/lattice.hpp"
#include "solver/make_stepper.hpp"

namespace sabo {
namespace {

constexpr double depth = 3.75, friction_angle = 28, g = 9.81;

struct Slab {
  double slope;   ///< rad
  double ratio;   ///< mu_0 over mu_B
  int layers;     ///< particles in the depth
  int dimension;  ///< 2 or 3
  /// The stress operator and walls as published, instead of those of the settings.
  std::optional<BoundaryStress> published = std::nullopt;
  double friction = friction_angle;  ///< that the material has, degrees
};

/// Mean speed over time, from rest.
ChartSeries simulated(const Slab& slab, const VerifySettings& settings, double end) {
  NumericsCase numerics = settings.numerics();
  numerics.spacing = depth / slab.layers;
  if (slab.published) {
    numerics.viscous_operator = ViscousOperator::nested;
    numerics.boundary_stress = *slab.published;
  }
  MaterialCase material;
  material.density = 1726;
  material.law = Cross{1255, slab.ratio, 1};
  material.yield = {0, slab.friction, 0};
  Layer layer;
  layer.model = settings.model(material, numerics, depth);
  layer.model.dimension = slab.dimension;
  layer.model.gravity = {g * std::sin(slab.slope), 0, -g * std::cos(slab.slope)};
  layer.cells = slab.layers;
  layer.period = slab.dimension == 2 ? 12 : 8;
  const auto backend = layer.make();
  make_hydrostatic(*backend, depth);
  const auto stepper = make_stepper(numerics, *backend, nullptr);

  ChartSeries series{fmt::format("{} layers", slab.layers), {0}, {0}};
  constexpr int points = 24;
  for (int k = 1; k <= points; ++k) {
    const double time = end * k / points;
    stepper->advance_to(time);
    double sum = 0;
    for (const Vec3d& v : backend->fluid().velocity) sum += v.x;
    series.x.push_back(time);
    series.y.push_back(sum / static_cast<double>(backend->fluid().size()));
  }
  return series;
}

ChartSeries exact(double slope, double ratio, double end) {
  SlabSolution solution{slope, friction_angle * degree};
  solution.ratio = ratio;
  ChartSeries series{"one dimension", {0}, {0}};
  constexpr int points = 12;
  for (int k = 1; k <= points; ++k) {
    series.x.push_back(end * k / points);
    series.y.push_back(solution.mean_speed(series.x.back()));
  }
  series.has_markers = true;
  series.has_line = false;
  return series;
}

/// What the stress sum of the paper makes of the slab, by what its walls carry. The sum over a
/// plane weighs both sides by half: walls without stress halve the friction.
void add_published(const VerifySettings& settings, double end, Verdict& verdict) {
  const double slope = 33 * degree, ratio = 1e3;
  const double expected = exact(slope, ratio, end).y.back();
  for (const BoundaryStress stress :
       {BoundaryStress::own, BoundaryStress::mirror, BoundaryStress::none})
    for (const int layers : {5, 10})
      verdict.claims.push_back(Claim::told(
          fmt::format("33°, nested stress sum, boundary_stress \"{}\", {} layers: speed at 3 s",
                      word_of(stress), layers),
          "m/s", simulated({slope, ratio, layers, 2, stress}, settings, end).y.back(), expected));
}

/// With r = tan(slope) / tan(friction angle) below 1 the shear rate is x tau_B / mu_0, x = r / (1 -
/// r) (to mu_B / mu_0), so the mean speed is x rho g cos(slope) tan(friction angle) H^2 / (3 mu_0).
double creep(double slope, double ratio) {
  const double friction = std::tan(friction_angle * degree);
  const double r = std::tan(slope) / friction;
  return r / (1 - r) * 1726 * g * std::cos(slope) * friction * depth * depth / (3 * 1255 * ratio);
}

}  // namespace

Verdict verify_slab(const VerifySettings& settings) {
  constexpr double end = 3;  // s
  const double steep = 33 * degree, gentle = 16 * degree;
  Verdict verdict;
  double done = 0;
  const auto report = [&](double share) { settings.on_progress(done += share); };
  const std::vector<double> ratios =
      settings.is_quick() ? std::vector{1e3} : std::vector{1e3, 1e4, 1e5};
  for (const double ratio : ratios) {
    LineChart chart{fmt::format("Slab on 33 degrees, μ0/μB = {:g}", ratio), "time [s]",
                    "mean speed [m/s]"};
    const ChartSeries reference = exact(steep, ratio, end);
    for (const int layers : {5, 10}) {
      chart.series.push_back(simulated({steep, ratio, layers, 2}, settings, end));
      verdict.claims.push_back(Claim::within_share(
          fmt::format("33°, μ0/μB {:g}, {} layers: speed at 3 s", ratio, layers), "m/s",
          chart.series.back().y.back(), reference.y.back(), layers == 5 ? 0.05 : 0.02));
      report(0.45 / static_cast<double>(ratios.size()));
    }
    chart.series.push_back(reference);
    verdict.charts.push_back(std::move(chart));
  }
  const double creeping = creep(gentle, 1e3);
  const ChartSeries below = simulated({gentle, 1e3, 10, 2}, settings, 2);
  verdict.claims.push_back(Claim::at_most("16°, μ0/μB 1000: speed at 2 s over that of creep", "",
                                          below.y.back() / creeping, 1.5));
  // tan 30 - tan 28 degrees are two fifths of the tan 33 - tan 28 that drive it.
  verdict.claims.push_back(Claim::at_most(
      "33°, μ0/μB 1000, 10 layers, friction angle 30 instead of 28°: speed over the exact one", "",
      simulated({steep, 1e3, 10, 2, std::nullopt, 30}, settings, end).y.back() /
          exact(steep, 1e3, end).y.back(),
      0.9));
  verdict.remarks.push_back(
      fmt::format("{:g} m deep, ρ 1726 kg/m³, friction angle {:g}°, Cross of μB 1255 Pa s", depth,
                  friction_angle));
  if (settings.method == Method::paper && !settings.is_quick()) {
    add_published(settings, end, verdict);
    verdict.remarks.push_back(
        "the two-point operator with mirrored walls holds the slab too much, at 10 layers half as "
        "much as at 5: an error of first order in the spacing");
  }
  report(0.1);
  return verdict;
}

}  // namespace sabo
