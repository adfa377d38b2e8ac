// A block of water 0.3 m high breaks out over a wet floor and strikes a square column: the force on
// it. Experiment of Yeh and Petroff (University of Washington); set-up in Gomez-Gesteira &
// Dalrymple, J. Waterw. Port Coast. Ocean Eng. 130 (2004) 63.

#include <cmath>
#include <optional>

#include "verify/cases.hpp"
#include "verify/drawn_gate.hpp"
#include "verify/water.hpp"
#include <fmt/format.h>

#include "solver/flow_model.hpp"
#include "solver/make_backend.hpp"
#include "solver/make_stepper.hpp"

namespace sabo {
namespace {

constexpr double length = 1.6, width = 0.61, height = 0.6;  // m; the tank was 0.75 m high
constexpr double water_length = 0.4, water_depth = 0.3, bed_depth = 0.01;
constexpr Box column{{0.9, 0.24, 0}, {1.02, 0.36, height}};
constexpr double fastest = 3;  // m/s

// Raad & Bidoae, J. Comput. Phys. 203 (2005) 668, Fig. 18, digitised (pysph, db_exp_data.py); means
// over 20 ms from 0.3 s on, every 20 ms, N.
const std::vector<double> measured_force{
    -0.2, 0.1,  2.1,  12.9, 26.0, 32.3, 31.3, 27.7, 23.6, 20.8, 19.4, 18.9, 18.9,
    18.6, 18.0, 18.1, 17.8, 17.6, 17.5, 17.7, 17.8, 16.9, 16.6, 16.2, 15.7, 15.3,
    15.6, 15.7, 14.5, 14.3, 12.7, 12.0, 11.4, 10.4, 10.0, 8.9,  8.4,  6.8,  7.8,
    7.8,  6.8,  6.1,  5.3,  5.0,  5.1,  5.2,  4.5,  3.8,  3.7,  3.7,  2.9,  3.0};
// Of the digitised curve itself.
constexpr double measured_peak = 32.4;      // N, greatest mean over 20 ms; 33.1 N at its highest
constexpr double quarter = 8.3;             // N, of the highest
constexpr double measured_arrival = 0.358;  // s, when it first exceeds that quarter
constexpr double measured_plateau = 17.9;   // N, mean over 0.55-0.70 s
constexpr double measured_impulse = 13.4;   // N s, over 0.33-1.33 s

struct Run {
  double spacing;    // m
  double end = 1.4;  // s
  MaterialCase material = water();
  bool has_gate = false;  // one drawn by a falling weight, else none
};

/// The floor from `start` on is wet wherever the spacing can show it.
void add_bed(Particles& fluid, const FlowModel& model, double start) {
  const auto add = [&](double x0, double x1, double y0, double y1) {
    add_still_box(fluid, model, {{x0, y0, 0}, {x1, y1, bed_depth}});
  };
  const Vec3d &low = column.low, &high = column.high;
  add(start, low.x, 0, width);
  add(low.x, high.x, 0, low.y);
  add(low.x, high.x, high.y, width);
  add(high.x, length, 0, width);
}

/// Force on the column along the tank.
TimeIntegral simulated(const VerifySettings& settings, const Run& run,
                       const std::function<void(double share)>& on_progress) {
  const NumericsCase numerics = water_numerics(settings, run.spacing, fastest);
  const FlowModel model = flow_model(run.material, numerics, water_depth);
  const auto backend = make_backend(numerics.backend, model);
  Tank{{{}, {length, width, height}}}.add_to(backend->boundary(), model);
  add_box(backend->boundary(), model, column, 1);
  add_still_box(backend->fluid(), model, {{}, {water_length, width, water_depth}});
  std::optional<DrawnGate> gate;
  double bed_start = water_length;
  if (run.has_gate) {
    bed_start += model.wall_layers() * run.spacing;
    const Box closed{{water_length, 0, 0}, {bed_start, width, height}};
    gate.emplace(*backend, closed, 2, norm(model.gravity));
  }
  if (run.spacing < 2.5 * bed_depth) add_bed(backend->fluid(), model, bed_start);
  const auto stepper = make_stepper(numerics, *backend, nullptr);
  TimeIntegral force;
  const auto keep = [&](double time) {
    force.set(time, stepper->body_impulses()[0].force.x);
    if (gate) gate->rise_to(time);
  };
  run_until(*stepper, run.end, keep, on_progress);
  return force;
}

/// Times count from the arrival, so that they do not hang on how the gate was drawn.
double late(const TimeIntegral& force) {
  return force.rises_above(quarter, 0.005) - measured_arrival;
}

double impulse(const TimeIntegral& force) {
  return force.integral(0.33 + late(force), 1.33 + late(force));
}

void add_claims(const TimeIntegral& force, double spacing, Verdict& verdict) {
  const auto what = [&](const char* text) { return fmt::format("dp {:g} m: {}", spacing, text); };
  const auto add = [&](Claim claim) { verdict.claims.push_back(std::move(claim)); };
  const double shift = late(force);
  add(Claim::within(what("the force passes 8.3 N at"), "s", measured_arrival + shift,
                    measured_arrival, 0.02));
  add(Claim::within_share(what("greatest force, means over 20 ms"), "N",
                          force.peak(0.02, 0.2, 0.6).value, measured_peak, 0.2));
  add(Claim::within_share(what("mean force over 0.15 s, from 0.19 s after arrival"), "N",
                          force.mean(0.55 + shift, 0.70 + shift), measured_plateau, 0.15));
  add(Claim::within_share(what("impulse over 1 s, from 0.03 s before arrival"), "N s",
                          impulse(force), measured_impulse, 0.1));
}

void tell(const TimeIntegral& force, double spacing, Verdict& verdict) {
  const auto add = [&](const char* text, const char* unit, double measured, double expected) {
    const std::string what = fmt::format("dp {:g} m, gate drawn up: {}", spacing, text);
    verdict.claims.push_back(Claim::told(what, unit, measured, expected));
  };
  add("the force passes 8.3 N at", "s", measured_arrival + late(force), measured_arrival);
  add("greatest force, means over 20 ms", "N", force.peak(0.02, 0.2, 0.6).value, measured_peak);
}

}  // namespace

Verdict verify_column_force(const VerifySettings& settings) {
  constexpr double coarse = 0.04, fine = 0.006;  // m
  // The explicit method takes ten times as long.
  const double full = settings.method == Method::fast ? 0.01 : 0.02;
  Verdict verdict;
  LineChart chart{"Force on a column behind a dam break", "time [s]", "force [N]"};
  double done = 0;
  const auto simulate = [&](const Run& run, double share) {
    TimeIntegral force =
        simulated(settings, run, [&](double part) { settings.on_progress(done + share * part); });
    done += share;
    return force;
  };
  const auto simulate_drawn = [&](const Run& run, double share) {
    TimeIntegral force = simulate(run, share);
    chart.series.push_back(
        force.series(fmt::format("dp {:g} m{}", run.spacing, run.has_gate ? ", gate drawn up" : ""),
                     0.01, run.end));
    return force;
  };
  if (settings.is_quick()) {
    // The flow is two spacings deep: little more than the order of its force can be asked for.
    verdict.claims.push_back(Claim::within_share(fmt::format("dp {:g} m: impulse over 1 s", coarse),
                                                 "N s", impulse(simulate_drawn({coarse}, 0.5)),
                                                 measured_impulse, 0.5));
  } else {
    const bool is_long = settings.effort == Effort::extended;
    const Run gated{.spacing = full, .end = 0.65, .has_gate = true};
    add_claims(simulate_drawn({full}, is_long ? 0.13 : 0.7), full, verdict);
    if (is_long) add_claims(simulate_drawn({fine}, 0.78), fine, verdict);
    tell(simulate_drawn(gated, is_long ? 0.07 : 0.28), full, verdict);
  }
  Run slurry{coarse};
  slurry.material.law = Newtonian{100};
  const TimeIntegral control = simulate(slurry, 1 - done);
  verdict.claims.push_back(
      Claim::at_most(fmt::format("dp {:g} m: impulse of a fluid of 100 Pa s up to 1.33 s", coarse),
                     "N s", control.integral(0, 1.33), 0.5 * measured_impulse));
  chart.series.push_back(measured_series("experiment", 0.3, 0.02, measured_force));
  verdict.charts = {std::move(chart)};
  verdict.remarks = {
      fmt::format("Artificial viscosity {:g}. The wet bed, {:g} m deep, is one layer of particles, "
                  "flat ones at dp 0.02 m; at dp {:g} m the floor is dry",
                  water_artificial_viscosity, bed_depth, coarse),
      "Arrival: by Stoker (1957) a bore runs over 1 cm of water at 1.89 m/s and needs 0.26 s from "
      "the gate to the column; in the plane water 3 cm deep is there at 0.284, 0.284 and 0.280 s "
      "with 0.01, 0.005 and 0.0025 m. The measured 0.358 s hold the time in which the gate was "
      "drawn, which is not known; other times count from the arrival",
      "Gate drawn up: as fast as a falling weight can, at g; it is out of the water in √(2H/g), "
      "which Lauber & Hager (1998) still call sudden. The measured arrival lies between that and a "
      "gate that is gone at once; the first blow is nearly the same with either",
      "First blow: it falls with the spacing, by the method fast 56.6, 53.4 and 45.3 N with 0.02, "
      "0.0142 and 0.01 m, and is not yet at its limit; mean force and impulse rise, 15.1, 16.1 "
      "and 17.3 N, 11.0, 11.9 and 12.2 N s"};
  return verdict;
}

}  // namespace sabo
