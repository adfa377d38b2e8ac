// A plane jet of water without weight strikes a wide plate and is turned aside: the force on the
// plate is the momentum that the jet carries in a time, F = rho b u^2 per metre across (Batchelor
// 1967, section 6.3), the pressure on it that of free streamlines (direct impact of a jet,
// Milne-Thomson, Theoretical Hydrodynamics, chapter XI).

#include <array>
#include <cmath>

#include "verify/cases.hpp"
#include "verify/jet_pressure.hpp"
#include "verify/water.hpp"
#include <fmt/format.h>

#include "analysis/probes.hpp"
#include "solver/make_backend.hpp"
#include "solver/make_stepper.hpp"

namespace sabo {
namespace {

constexpr double thickness = 0.1, speed = 2;  // m, m/s
constexpr double length = 10 * thickness;     // of the jet
constexpr double half_plate = 6 * thickness;  // m; sheets leave it along its face
constexpr double turn = thickness / speed;    // s
constexpr double plateau_start = 3 * turn, plateau_end = 8 * turn, end = 9 * turn;

// With the 0.02 of the other water cases the sheets that leave along the plate, and stretch, come
// under tension until a density leaves its range.
constexpr double artificial_viscosity = 0.05;

constexpr std::array places{0.0, 0.5, 1.0};  // on the plate, from its middle, over the thickness

struct Strike {
  TimeIntegral force;                                     ///< on the plate, per metre across
  std::array<TimeIntegral, places.size()> pressure = {};  ///< at both sides, their mean
  double momentum = 0;  ///< that the jet had towards the plate, kg m/s
  double kept = 0;      ///< that it still has in the end
  double lost() const { return momentum - kept; }
};

double momentum_down(const Particles& fluid) {
  double sum = 0;
  for (std::size_t i = 0; i < fluid.size(); ++i) sum -= fluid.mass[i] * fluid.velocity[i].z;
  return sum;
}

Strike simulated(const VerifySettings& settings, int layers, double density,
                 const std::function<void(double share)>& on_progress) {
  // The first blow is that of a water hammer, rho c u: twice the speed keeps its density in range.
  NumericsCase numerics = water_numerics(settings, thickness / layers, 2 * speed);
  numerics.reference_speed = 2 * speed;
  numerics.gravity = 0;
  numerics.artificial_viscosity = artificial_viscosity;
  MaterialCase material = water();
  material.density = density;
  FlowModel model = settings.model(material, numerics, thickness);
  model.dimension = 2;
  const auto backend = make_backend(numerics.backend, model);
  const double dp = model.spacing, half = 0.5 * thickness;
  Particles& fluid = backend->fluid();
  add_box(fluid, model, {{-half, 0, dp}, {half, 0, dp + length}});
  for (Vec3d& velocity : fluid.velocity) velocity = {0, 0, -speed};
  const double wall = model.wall_layers() * dp;
  add_box(backend->boundary(), model, {{-half_plate, 0, -wall}, {half_plate, 0, 0}}, 1);
  Strike strike;
  strike.momentum = momentum_down(fluid);
  const auto stepper = make_stepper(numerics, *backend, nullptr);
  const auto kernel = model.kernel<double>();
  const auto pressure = [&](double x) {
    return pressure_at(fluid, {x, 0, 0}, kernel, model.gravity);
  };
  const auto keep = [&](double time) {
    strike.force.set(time, -stepper->body_impulses()[0].force.z);
    for (std::size_t k = 0; k < places.size(); ++k) {
      const double x = places[k] * thickness;
      strike.pressure[k].go_on(time, 0.5 * (pressure(x) + pressure(-x)));
    }
  };
  run_until(*stepper, end, keep, on_progress);
  strike.kept = momentum_down(fluid);
  return strike;
}

}  // namespace

Verdict verify_jet(const VerifySettings& settings) {
  const double expected = water().density * thickness * speed * speed;  // N/m
  const std::vector<int> resolutions = settings.is_quick() ? std::vector{14} : std::vector{20, 40};
  Verdict verdict;
  LineChart chart{"Force of a plane jet on a plate", "time [s]", "force [N/m]"};
  // A run costs as the cube of its layers; the last one is the control.
  const int control_layers = settings.is_quick() ? 14 : 20;
  double total = std::pow(control_layers, 3), done = 0;
  for (const int layers : resolutions) total += std::pow(layers, 3);
  const auto run = [&](int layers, double density) {
    const double cost = std::pow(layers, 3);
    Strike strike = simulated(settings, layers, density, [&](double share) {
      settings.on_progress((done + share * cost) / total);
    });
    done += cost;
    return strike;
  };
  for (const int layers : resolutions) {
    const Strike strike = run(layers, water().density);
    verdict.claims.push_back(Claim::within_share(
        fmt::format("b/dp {}: force over {:g}-{:g} s", layers, plateau_start, plateau_end), "N/m",
        strike.force.mean(plateau_start, plateau_end), expected,
        settings.is_quick() ? 0.08 : 0.05));
    verdict.claims.push_back(
        Claim::within_share(fmt::format("b/dp {}: impulse, of the momentum lost", layers), "N s/m",
                            strike.force.integral(0, end), strike.lost(), 0.02));
    for (std::size_t k = 0; k < places.size(); ++k)
      verdict.claims.push_back(Claim::within(
          fmt::format("b/dp {}: pressure on the plate at {:g} b, over ρ u²/2", layers, places[k]),
          "", strike.pressure[k].mean(plateau_start, plateau_end) / (0.5 * expected / thickness),
          jet_pressure(places[k]), settings.is_quick() ? 0.08 : 0.05));
    chart.series.push_back(strike.force.series(fmt::format("b/dp {}", layers), 0.1 * turn, end));
  }
  const double more = settings.is_quick() ? 0.2 : 0.1;
  const Strike heavy = run(control_layers, (1 + more) * water().density);
  verdict.claims.push_back(
      Claim::at_least(fmt::format("b/dp {}, a jet heavier by {:g} %: force over that of water",
                                  control_layers, 100 * more),
                      "", heavy.force.mean(plateau_start, plateau_end) / expected,
                      1 + (settings.is_quick() ? 0.08 : 0.05)));
  chart.references = {{expected, "ρ b u²"}};
  chart.y_high = 2 * expected;
  verdict.charts = {std::move(chart)};
  verdict.remarks = {fmt::format(
      "b {:g} m, u {:g} m/s, c0 {:g} m/s at least, artificial viscosity {:g}. The first blow, a "
      "water hammer, goes beyond the chart",
      thickness, speed, settings.numerics().sound_speed_factor * 2 * speed, artificial_viscosity)};
  return verdict;
}

}  // namespace sabo
