#pragma once

#include "verify/verification.hpp"

#include "case/case.hpp"
#include "solver/lattice.hpp"
#include "solver/stepper.hpp"

namespace sabo {

/// Monaghan's alpha of the cases with water, whose own viscosity no spacing resolves.
inline constexpr double water_artificial_viscosity = 0.02;

MaterialCase water();

/// The settings under test with a spacing, artificial viscosity and the speed (m/s) that the sound
/// speed of the explicit method has to be ready for; that of `fast` follows the flow.
NumericsCase water_numerics(const VerifySettings& settings, double spacing, double fastest);

/// Steps to the end (s), calling `after_step(time)` and now and then `on_progress` with the share
/// of the time that has passed.
void run_until(Stepper& stepper, double end, const std::function<void(double time)>& after_step,
               const std::function<void(double share)>& on_progress);

/// A quantity over time that is known by its integral, so that its means miss nothing.
class TimeIntegral {
 public:
  /// The integral at a time (s) later than the last one.
  void set(double time, double integral);
  /// Goes on from the last time with a value.
  void go_on(double time, double value);

  double integral(double from, double to) const { return at(to) - at(from); }
  double mean(double from, double to) const { return integral(from, to) / (to - from); }
  /// Mean over `window` (s) around a time.
  double around(double time, double window) const;

  struct Peak {
    double value, time;
  };
  /// The greatest mean over a window within a range of times.
  Peak peak(double window, double from, double to) const;
  /// When the mean over a window first exceeds a level; NaN when it never does.
  double rises_above(double level, double window) const;

  /// Means over `step` (s) one after the other.
  ChartSeries series(std::string name, double step, double end) const;

 private:
  double at(double time) const;

  std::vector<double> time_{0}, integral_{0};
};

/// Measured values as markers.
ChartSeries measured_series(std::string name, double start, double step,
                            const std::vector<double>& values);

}  // namespace sabo
