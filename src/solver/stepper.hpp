#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

#include "backend/backend.hpp"
#include "physics/time_step.hpp"
#include "solver/domain.hpp"

namespace sabo {

/// What a step was like.
struct StepReport {
  double dt = 0;           ///< s
  FlowExtremes flow;       ///< at the start of the step
  double sound_speed = 0;  ///< m/s
  int iterations = 0;      ///< of the implicit viscosity

  template <class Archive>
  void archive(Archive& a) {
    a(dt, flow, sound_speed, iterations);
  }
};

/// Carries the state of a backend forward in time: one of the methods.
class Stepper {
 public:
  /// `domain` may be null: then the boundary is what the caller put there.
  Stepper(Backend& backend, Domain* domain);
  Stepper(const Stepper&) = delete;
  Stepper& operator=(const Stepper&) = delete;
  virtual ~Stepper() = default;

  /// Largest deviation of rho / rho0 from 1 that a run survives.
  static constexpr double density_tolerance = 0.1;

  /// One step, no longer than `longest` (s). Throws RunError when the state is no longer finite or
  /// a density has left its range.
  StepReport step(double longest = std::numeric_limits<double>::infinity());

  /// Steps, each no longer than `longest` (s), until the time is `time` (s).
  void advance_to(double time, double longest = std::numeric_limits<double>::infinity());

  double time() const { return time_; }  ///< s
  /// Before the first step: the flow is that of another time than 0.
  void start_at(double time) { time_ = time; }
  std::size_t steps() const { return steps_; }
  /// Heat made by viscosity so far, J.
  double dissipated() const { return backend_.heat().viscosity; }
  /// What each body has been given so far, number 1 first: the loads of every step over its time,
  /// N s and N m s. Its difference over an interval by the interval is the mean load.
  const std::vector<BodyLoad>& body_impulses() const { return body_impulses_; }

  /// Whether inflows have changed the particles since neighbours were found: no state to go on
  /// from.
  bool neighbours_are_due() const { return particles_changed_; }

  /// Without the backend and the domain; while no neighbours are due.
  template <class Archive>
  void archive(Archive& a) {
    a(time_, steps_, body_impulses_);
  }

 protected:
  /// Moves the state over one step.
  virtual StepReport advance(double longest) = 0;

  void renew_neighbours();

  Backend& backend_;

 private:
  void advance_inflows(double dt);
  void check_health() const;

  Domain* domain_;
  bool particles_changed_ = false;  // by inflows, since the neighbours were found
  double time_ = 0;
  std::size_t steps_ = 0;
  std::vector<BodyLoad> body_impulses_;
};

}  // namespace sabo
