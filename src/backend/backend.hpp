#pragma once

#include <functional>
#include <future>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "backend/body_load.hpp"
#include "backend/chosen_step.hpp"
#include "backend/heat_account.hpp"
#include "backend/model.hpp"
#include "backend/pass_times.hpp"
#include "backend/viscous_solve.hpp"
#include "base/archive.hpp"
#include "particles/boundary_change.hpp"
#include "particles/particle_rows.hpp"
#include "particles/places.hpp"

namespace sabo {

/// State of a flow that the user or the run should hear of.
struct FlowHealth {
  double min_density_ratio = 1;  ///< of fluid particles, rho / rho0
  double max_density_ratio = 1;
  bool is_finite = true;  ///< no NaN or infinity in position, velocity or density
};

/// The fluid as it was at some time, while the flow goes on: get() waits until the host has it.
/// From any thread, each with an object of its own; to be asked for before the backend goes.
using KeptFluid = std::shared_future<Particles>;

/// A fluid that the host has already.
inline KeptFluid kept_already(Particles fluid) {
  std::promise<Particles> promise;
  promise.set_value(std::move(fluid));
  return promise.get_future();
}

/// The fluid at the head of an archived backend.
struct ArchivedFluid {
  double sound_speed = 0;  ///< to which its densities belong, m/s
  Particles particles;

  template <class Archive>
  void archive(Archive& a) {
    a.mark("backend");
    a(sound_speed, particles);
  }
};

/// Arrays of particles and the loops over them. The solver calls the sweeps in the order of the
/// physics; a sweep reads what the ones before it wrote. Implementations differ in where the arrays
/// live and how pairs are found, never in the formulas (src/physics).
///
/// Driven particles (Particles::driven) are neighbours to the others as all are, but keep the
/// velocity and density that they were given, and move with it; their shear rate is given, too.
class Backend {
 public:
  explicit Backend(const FlowModel& model) : model_(model) {}
  Backend(const Backend&) = delete;
  Backend& operator=(const Backend&) = delete;
  virtual ~Backend() = default;

  const FlowModel& model() const { return model_; }

  /// State on the host. After a change from outside, find_neighbours() must run before any sweep.
  /// May be a copy, which holds what it held when it was asked for: ask again after a sweep, and
  /// after rows have changed.
  virtual Particles& fluid() = 0;
  virtual Particles& boundary() = 0;
  /// A copy of the fluid as it is, for the host to keep; may be the one that was asked for last, if
  /// nothing has changed.
  virtual KeptFluid keep_fluid() = 0;
  /// Where the fluid is: less than all that fluid() fetches, and nothing to hand back. Good until
  /// the next sweep or change of rows.
  virtual std::span<const Vec3d> positions() = 0;
  /// The same with numbers and masses, in the order of fluid().
  virtual Places places() = 0;
  /// Takes boundary particles out and adds others, where they are; as a change from outside.
  virtual void change_boundary(const BoundaryChange& change) = 0;

  /// Lets a function change the fluid of some rows, sorted, each once, as they are in fluid(); it
  /// takes none out, and what it appends comes last. As a change from outside.
  virtual void change_rows(const ParticleRows& rows,
                           const std::function<void(Particles&)>& change) = 0;
  /// Takes the fluid of some rows out; likewise.
  virtual Particles take_out(const ParticleRows& rows) = 0;
  /// Rows of the driven particles, sorted, until the next change from outside.
  virtual ParticleRows driven_rows() const = 0;
  /// Lets a function change place and velocity of the driven particles, all of which are among
  /// those that it is given; neighbours need not be found anew.
  virtual void change_driven(const std::function<void(Particles&)>& change) = 0;

  /// Numbers of particles, without a copy.
  virtual std::size_t fluid_count() const = 0;
  virtual std::size_t boundary_count() const = 0;

  /// Whether some particle may have moved too far for the neighbour list once it has moved by
  /// `margin` (m) more.
  virtual bool neighbours_are_stale(double margin) const = 0;
  /// Distance within which the list holds every pair at the time it is made, m.
  virtual double list_radius() const = 0;
  /// Sorts the particles, wraps periodic positions and lists the pairs.
  virtual void find_neighbours() = 0;

  /// Pressure of all particles from their density (Eq. 14).
  virtual void pressure() = 0;
  /// Strain rate of all particles (Eq. 16) and rate of density (Eqs. 7, 11).
  virtual void strain_and_density_rates() = 0;
  /// Yield stress, effective viscosity and stress of all particles (Eqs. 17, 21-26).
  virtual void stress() = 0;
  /// Acceleration of the fluid (Eqs. 13, 18).
  virtual void momentum() = 0;

  /// Density of boundary particles from the pressure of the fluid near them, carried along the
  /// gravity (Adami et al. 2012, Eq. 27 for walls at rest); at least the reference density. For the
  /// start of a run: later the boundary follows continuity. Needs pressure().
  virtual void extrapolate_to_boundary() = 0;

  /// How long the step is that the state is to be moved by, from the extremes of the last
  /// evaluation; at most `longest` (s).
  virtual void choose_step(const StepRule& rule, double longest) = 0;
  void fix_step(double dt) { choose_step(FixedStep{dt}, dt); }
  /// What has been chosen; waits until it is known.
  virtual ChosenStep chosen_step() const = 0;

  // The sweeps of the implicit method, in their order within a step.

  /// Pressure of boundary particles near the fluid, as above, for this step.
  virtual void wall_pressure() = 0;
  /// Acceleration of the fluid by gravity, pressure and artificial viscosity; the viscous matrix;
  /// where the walls are.
  virtual void near_forces() = 0;
  /// Resistance of the walls to the flow along them, by the wall law.
  virtual void wall_resistance() = 0;
  /// v <- v + dt a over the chosen step, with viscosity and walls implicit:
  /// (M + dt K + dt D) v' = M (v + dt a) + dt D w. The residual ends below `tolerance`, or nothing
  /// changes and the solve has not converged.
  virtual ViscousSolve advance_velocity(const VelocityTolerance& tolerance,
                                        int most_iterations) = 0;
  /// Strain rate and rate of density of the fluid with its new velocity; friction on bodies.
  virtual void near_motion() = 0;
  /// Moves density and position over the chosen step, then finds the pressure of the fluid and its
  /// effective viscosity.
  virtual void advance_state() = 0;
  /// Lets calm particles fall asleep and wakes those whose neighbours move. A sleeping particle is
  /// at rest, keeps its pressure, and is a neighbour to the others as before.
  virtual void update_sleep() = 0;
  virtual std::size_t asleep_count() const = 0;
  /// Another speed of sound (m/s); densities change so that pressures do not.
  virtual void set_sound_speed(double c0) = 0;

  /// The greatest speed of particles with neighbours, m/s; may count those that have just fallen
  /// asleep.
  virtual double fastest() const = 0;
  virtual FlowHealth health() const = 0;
  /// Since the start. May be a copy: ask again after a step.
  virtual const HeatAccount& heat() const = 0;

  /// From the next list of neighbours on loads of foundations act at this level.
  void set_ground_level(GroundLevel level) { ground_level_ = std::move(level); }
  /// What the fluid does to each body at the last evaluation, number 1 first: minus what its
  /// particles do to the fluid, by pressure, artificial viscosity and stress; in the implicit
  /// method also by the wall law, from near_motion() on. Particles that sleep press as they last
  /// did, without friction. Of the ground under a body it has the horizontal part. Empty without
  /// bodies.
  virtual const std::vector<BodyLoad>& body_loads() const = 0;
  /// The same, particle by particle of the bodies.
  virtual const std::vector<BodyForce>& body_forces() const = 0;

  /// Keeps the state as the start of the chosen step and moves it by half of it with the current
  /// rates.
  virtual void predict() = 0;
  /// Moves from the start of the chosen step over the whole of it with the rates at its middle.
  virtual void correct() = 0;

  /// Accelerations of the last evaluation, in the present order of the fluid, m/s2.
  virtual const std::vector<Vec3d>& accelerations() const = 0;
  /// Rates of density of the last evaluation; fluid first, then boundary, kg/m3/s.
  virtual const std::vector<double>& density_rates() const = 0;

  /// Memory that the arrays take on a device of their own, bytes, from which fluid() and boundary()
  /// have to copy; 0 for those of the host.
  virtual std::size_t device_bytes() const { return 0; }

  /// Time that each pass has taken; others, as the solver, may clock theirs here as well.
  virtual PassTimes& pass_times() { return pass_times_; }

  /// The state between two steps. What is read, by a backend of the same kind and model, goes on
  /// with the same bits. Throws RunError for what cannot be a state.
  virtual void archive(ArchiveWriter& a) = 0;
  virtual void archive(ArchiveReader& a) = 0;

 protected:
  FlowModel model_;
  GroundLevel ground_level_;      // may be none
  mutable PassTimes pass_times_;  // sums that change nothing are clocked as well
};

}  // namespace sabo
