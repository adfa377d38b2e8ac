#pragma once

#include <deque>
#include <vector>

#include "particles/particles.hpp"

namespace sabo {

/// When a flow counts as at rest. All limits have to hold at once.
struct RestLimits {
  double time = 10;            ///< s: displacement is measured over it, and energy stays low for it
  double speed = 0.01;         ///< m/s, displacement over `time`: what is faster moves
  double volume_share = 0.01;  ///< of the released volume that may still move
  double energy_share = 1e-4;  ///< kinetic energy over its peak
  double creep = 1;            ///< mean displacement, spacings a minute
};

/// How much a flow moves.
struct MotionState {
  double moving_volume = 0;  ///< m3, of particles above the limit of speed
  double moving_share = 0;   ///< the same over the released volume
  double energy_share = 0;   ///< kinetic energy over its peak so far; 0 while nothing has moved
  double creep = 0;          ///< mean displacement, spacings a minute
  bool has_moved = false;    ///< more than the limit of volume has gone further than a spacing
  bool is_at_rest = false;

  template <class Archive>
  void archive(Archive& a) {
    a(moving_volume, moving_share, energy_share, creep, has_moved, is_at_rest);
  }
};

/// Watches a flow for rest.
///
/// Speed is the displacement over the last `RestLimits::time` (to a quarter longer), not the
/// particle's velocity: a particle that trembles in its place goes nowhere, and a regularised fluid
/// below its yield stress creeps steadily at a velocity that is as small. Mass that has not moved
/// yet is not at rest but about to start.
class RestWatch {
 public:
  /// `spacing` in m, density in kg/m3. Before `last_start` (s), when the last of the mass starts to
  /// move, nothing counts as rest.
  RestWatch(const RestLimits& limits, double spacing, double reference_density,
            double last_start = 0);

  /// How often the watch needs to see the particles at least, s.
  double interval() const { return limits_.time / 4; }

  /// Takes in the particles as they are at `time` (s); times must not decrease. Particles are known
  /// by their number; new ones count as released at their first sight.
  void update(double time, const Particles& particles);

  const MotionState& state() const { return state_; }
  /// Whether the flow may turn out to be at rest when it is next seen, at `time` (s).
  bool may_find_rest(double time) const { return has_lasted(time - calm_since_); }

  template <class Archive>
  void archive(Archive& a) {
    a(kept_, start_, released_, peak_energy_, calm_since_, state_);
  }

 private:
  /// Positions by particle number at one moment; NaN of those that were not there.
  struct Kept {
    double time = 0;
    std::vector<Vec3d> position;

    template <class Archive>
    void archive(Archive& a) {
      a(time, position);
    }
  };
  struct Sums;

  bool is_due(double time) const { return kept_.empty() || time >= kept_.back().time + interval(); }
  bool has_lasted(double duration) const;
  void keep(double time, const Particles& particles);
  void greet(const Particles& particles);
  Sums sums_over(const Particles& particles, double age) const;

  RestLimits limits_;
  double spacing_;
  double reference_density_;
  double last_start_;
  std::deque<Kept> kept_;     // the first is the start of the window
  std::vector<Vec3d> start_;  // where each was first seen, by number
  double released_ = 0;       // kg
  double peak_energy_ = 0;    // J
  double calm_since_ = 0;     // energy has been below its limit since then, s
  MotionState state_;
};

}  // namespace sabo
