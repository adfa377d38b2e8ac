// Fluids at rest: the pressure is the weight above, nothing moves, and the density is what the
// equation of state makes of the pressure at the stated speed of sound.

#include <algorithm>
#include <array>
#include <cmath>

#include "verify/cases.hpp"
#include "verify/cases/still_pool.hpp"
#include <fmt/format.h>

#include "solver/make_stepper.hpp"

namespace sabo {
namespace {

constexpr double depth = 1, density = 1000, g = 9.81;  // m, kg/m3, m/s2

enum class Shape { column, wedge, flat_dem, rough_dem, box };

struct Variant {
  std::string name;
  Shape shape = Shape::column;
  int cells = 50;  ///< of the depth
  Rheology law = Newtonian{0.001};
  MohrCoulomb yield = {};
  double true_density = density;  ///< of what is in the pool, kg/m3

  std::string title() const { return fmt::format("{}, H/{}", name, cells); }
  bool is_flat() const { return shape == Shape::column || shape == Shape::wedge; }
};

StillPool pool_of(const Variant& variant, const FlowModel& model) {
  switch (variant.shape) {
    case Shape::wedge:
      return wedge_pool(model, depth);
    case Shape::flat_dem:
      return dem_pool(model, depth, false);
    case Shape::rough_dem:
      return dem_pool(model, depth, true);
    case Shape::box:
      return box_pool(model, depth);
    case Shape::column:
      break;
  }
  return column_pool(model, depth);
}

struct Outcome {
  double pressure_error = 0;   ///< relative L2
  double bottom_pressure = 0;  ///< of the wall that touches the fluid, over the exact one
  double surface_drift = 0;    ///< m
  double density_error = 0;    ///< greatest, over the reference density
  double speed = 0;            ///< greatest in the second half, m/s
  ChartSeries profile = {};    ///< error of the pressure over height
};

double exact_pressure(double below_surface) { return density * g * below_surface; }

double fastest(const Particles& fluid) {
  double most = 0;
  for (const Vec3d& v : fluid.velocity) most = std::max(most, norm(v));
  return most;
}

/// The sum of pressures of boundary particles within 1.2 spacings of the fluid, over the exact one.
double bottom_pressure(const StillPool& pool) {
  const FlowModel& model = pool.backend->model();
  const Particles& fluid = pool.backend->fluid();
  const Particles& wall = pool.backend->boundary();
  double sum = 0, exact = 0;
  for (std::size_t b = 0; b < wall.size(); ++b) {
    const bool touches = std::ranges::any_of(fluid.position, [&](const Vec3d& x) {
      return norm(model.periodic.nearest(x - wall.position[b])) < 1.2 * model.spacing;
    });
    if (!touches) continue;
    sum += wall.pressure[b];
    exact += std::max(0.0, exact_pressure(pool.level - wall.position[b].z));
  }
  return sum / exact;
}

/// Means over layers of the pressure less the exact one, over the greatest exact one, %.
ChartSeries error_profile(const StillPool& pool) {
  constexpr int layers = 20;
  std::array<double, layers> sums{}, counts{};
  const Particles& fluid = pool.backend->fluid();
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    const double z = fluid.position[i].z;
    const int layer = std::clamp(static_cast<int>(layers * z / depth), 0, layers - 1);
    sums[layer] += fluid.pressure[i] - exact_pressure(pool.level - z);
    ++counts[layer];
  }
  ChartSeries profile;
  for (int k = 0; k < layers; ++k) {
    if (counts[k] == 0) continue;
    profile.x.push_back((k + 0.5) * depth / layers);
    profile.y.push_back(100 * sums[k] / counts[k] / exact_pressure(depth));
  }
  return profile;
}

void measure(const StillPool& pool, Outcome& outcome) {
  const Particles& fluid = pool.backend->fluid();
  // The stated speed of sound is 10 sqrt(g depth); Tait's equation the other way round.
  const double b = density * 100 * g * depth / 7;
  double difference = 0, size = 0, top = -1;
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    const double exact = exact_pressure(pool.level - fluid.position[i].z);
    difference += (fluid.pressure[i] - exact) * (fluid.pressure[i] - exact);
    size += exact * exact;
    top = std::max(top, fluid.position[i].z);
    const double exact_density = density * std::pow(1 + std::max(0.0, exact) / b, 1.0 / 7);
    outcome.density_error =
        std::max(outcome.density_error, std::abs(fluid.density[i] - exact_density) / density);
  }
  outcome.pressure_error = std::sqrt(difference / size);
  outcome.bottom_pressure = bottom_pressure(pool);
  outcome.profile = error_profile(pool);
  outcome.surface_drift = top + 0.5 * pool.backend->model().spacing - pool.level;
}

Outcome run(const Variant& variant, double end, const VerifySettings& settings,
            const std::function<void(double share)>& on_progress) {
  NumericsCase numerics = settings.numerics();
  numerics.spacing = depth / variant.cells;
  if (std::holds_alternative<Newtonian>(variant.law)) numerics.artificial_viscosity = 0.02;
  MaterialCase material;
  material.density = variant.true_density;
  material.law = variant.law;
  material.yield = variant.yield;
  FlowModel model = settings.model(material, numerics, depth);
  model.dimension = variant.is_flat() ? 2 : 3;
  const StillPool pool = pool_of(variant, model);
  const auto stepper = make_stepper(numerics, *pool.backend, nullptr);
  Outcome outcome;
  constexpr int points = 40;
  for (int k = 1; k <= points; ++k) {
    stepper->advance_to(end * k / points);
    if (2 * k >= points) outcome.speed = std::max(outcome.speed, fastest(pool.backend->fluid()));
    on_progress(double(k) / points);
  }
  measure(pool, outcome);
  outcome.profile.name = variant.title();
  return outcome;
}

void add_claims(const Variant& variant, const Outcome& outcome, double end, Verdict& verdict) {
  const double dp = depth / variant.cells;
  const std::string where = fmt::format("{}, spacing H/{}: ", variant.name, variant.cells);
  verdict.claims.push_back(
      Claim::at_most(where + "L2 error of the pressure", "", outcome.pressure_error, 0.01));
  verdict.claims.push_back(Claim::within_share(where + "pressure of the wall over the exact one",
                                               "", outcome.bottom_pressure, 1, 0.01));
  verdict.claims.push_back(Claim::within(where + "drift of the surface, half a spacing", "m",
                                         outcome.surface_drift, 0, 0.5 * dp));
  verdict.claims.push_back(
      Claim::at_most(fmt::format("{}greatest speed after {:g} s over √(gH)", where, end / 2), "",
                     outcome.speed / std::sqrt(g * depth), 1e-3));
  verdict.claims.push_back(
      Claim::at_most(where + "density less the hydrostatic one, greatest over ρ0", "",
                     outcome.density_error, 0.003));
}

/// For the explicit method: see the remark on what it leaves out.
std::vector<Variant> variants_of_water() {
  return {{"column", Shape::column, 25},
          {"column", Shape::column, 50},
          {"wedge", Shape::wedge, 50},
          {"flat DEM", Shape::flat_dem, 25}};
}

std::vector<Variant> variants(bool quick) {
  const Variant bingham{"Bingham", Shape::column, quick ? 20 : 50, Bingham{{20, 1e4}}, {50, 0, 0}};
  if (quick) return {{"column", Shape::column, 20}, bingham, {"flat DEM", Shape::flat_dem, 10}};
  return {{"column", Shape::column, 25},
          {"column", Shape::column, 50},
          {"column", Shape::column, 100},
          bingham,
          {"Mohr-Coulomb", Shape::column, 50, Cross{20, 1e4, 1}, {0, 30, 0}},
          {"wedge", Shape::wedge, 50},
          {"flat DEM", Shape::flat_dem, 50},
          {"rough DEM", Shape::rough_dem, 50},
          {"DEM of 30° in a box", Shape::box, 50}};
}

}  // namespace

Verdict verify_hydrostatic(const VerifySettings& settings) {
  const bool quick = settings.is_quick();
  const double end = quick ? 2 : 10;
  const std::vector<Variant> list =
      settings.method == Method::paper && !quick ? variants_of_water() : variants(quick);
  const auto work_of = [](const Variant& variant) {
    return std::pow(variant.cells, 2) * (variant.is_flat() ? 1 : 20);
  };
  double work = 0, done = 0;
  for (const Variant& variant : list) work += work_of(variant);
  Verdict verdict;
  const auto chart_of = [](const std::string& pools) {
    return LineChart{"Error of the pressure at rest, " + pools, "height [m]",
                     "error over ρ g H, means of layers [%]"};
  };
  LineChart flat = chart_of("flat floors and a wedge"), dems = chart_of("DEMs");
  for (const Variant& variant : list) {
    const double part = work_of(variant) / work;
    Outcome outcome = run(variant, end, settings, [&](double share) {
      settings.on_progress(std::min(0.98, done + part * share));
    });
    done += part;
    add_claims(variant, outcome, end, verdict);
    outcome.profile.has_markers = true;
    (variant.is_flat() ? flat : dems).series.push_back(std::move(outcome.profile));
  }
  for (LineChart* chart : {&flat, &dems})
    if (!chart->series.empty()) verdict.charts.push_back(std::move(*chart));
  Variant heavy = list.front();
  heavy.true_density = 1.03 * density;
  verdict.claims.push_back(Claim::at_least("a fluid 3 % denser: L2 error of the pressure", "",
                                           run(heavy, 1, settings, [](double) {}).pressure_error,
                                           0.02));
  verdict.remarks = {fmt::format(
      "ρ {:g} kg/m³, water of 1e-3 Pa s with an artificial viscosity α of 0.02. Bingham: 50 Pa, "
      "20 Pa s; Mohr-Coulomb: 30°, Cross of 20 Pa s; both with μ0/μB 1e4",
      density)};
  if (!quick && settings.method == Method::fast) {
    verdict.remarks.push_back(
        "speed: pressures are in balance, for the vertical speed in the periodic column stays at "
        "some 3e-4 √(gH); whole rows of particles slide over each other, their heights unchanged. "
        "Sums over particles leave no arrangement at rest: a square lattice, one with its rows "
        "staggered by half a spacing or by other shares of it, closed walls instead of a period, "
        "h/dp from 1.2 to 2, more shifting or α 0.05 all stay above 1e-3. A column that slides "
        "loses the share ν (π/2H)² of its speed a second to its viscosity, 2.5 % for a fluid of "
        "10 Pa s, which has 0.003 √(gH) left after 10 s; one with a yield stress stands still");
    verdict.remarks.push_back(
        "speed on DEMs and over the wedge, as seen at H/25: on the flat DEM whole rows slide too, "
        "both ways, at 0.010 and 0.012 √(gH) with vertical speeds of 0.003. Over the wedge and the "
        "rough DEM no row stays whole: there vertical speeds are as great as horizontal ones, and "
        "both decay together");
    verdict.remarks.push_back(
        "box: the rows settle into another order for some seconds; whatever moves then is slowed "
        "by little but the artificial viscosity");
  }
  if (!quick && settings.method == Method::paper) {
    verdict.remarks.push_back(
        "left out for the time that they take: fluids with a yield stress, whose explicit steps "
        "are "
        "shorter by their viscosity at rest over that of water, H/100, the rough DEM and the box");
    verdict.remarks.push_back(
        "pressure and wall: too high towards the floor, by an error of the compression, which "
        "falls with the square of the speed of sound: L2 is 0.022 in the column of H/25 after 5 "
        "s, 0.007 with twice that speed. Density follows continuity, places do not: water that "
        "is laid out with the density of its depth but not compressed has particles that fill "
        "less than their places, and sums over them need a steeper pressure to carry it. 0.9 % "
        "of 2.6 % at the floor go when each particle has the mass that its density gives its "
        "place. Neither artificial viscosity 0.1 nor a pressure of walls by continuity lowers "
        "it much; without density diffusion it is 0.032. Speed: rows slide over each other here "
        "too, vertical speeds stay below 5e-4 √(gH)");
  }
  settings.on_progress(1);
  return verdict;
}

}  // namespace sabo
