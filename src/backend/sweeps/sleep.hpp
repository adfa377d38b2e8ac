#pragma once

#include "backend/flow_view.hpp"
#include "backend/sweeps/flow_sums.hpp"

// Which particles take part in the sweeps of the implicit method.

namespace sabo {

/// Asleep, or calm for long enough to fall asleep.
SABO_HD inline bool may_sleep(const FlowModel& model, double calm) {
  return model.sleep.speed > 0 && calm >= model.sleep.time;
}

/// That it was calm for longer says that WakeAndHold has put it to sleep. What may sleep is swept
/// until then: it still moves, and its neighbours see that.
SABO_HD inline bool is_asleep(const FlowModel& model, double calm) {
  return model.sleep.speed > 0 && calm > model.sleep.time;
}

/// Whether a fluid particle takes part in the sweeps.
struct IsAwake {
  FlowModel model;
  const double* calm;
  const std::uint16_t* driven;
  SABO_HD bool operator()(std::size_t i) const {
    return driven[i] == 0 && !is_asleep(model, calm[i]);
  }
};

struct MarkMoving {
  char* moves;
  SABO_HD void operator()(std::size_t i) const { moves[i] = 1; }
};

/// Slow, below yield and among others.
SABO_HD inline bool is_calm(const FlowView& flow, std::size_t i) {
  const SleepRule& rule = flow.model.sleep;
  if (!(rule.speed > 0) || !flow.has_neighbours[i]) return false;
  const ParticleView& fluid = flow.fluid;
  if (dot(fluid.velocity[i], fluid.velocity[i]) > rule.speed * rule.speed) return false;
  const double yield = flow.model.yield(fluid.pressure[i], flow.yield_slope);
  return fluid.viscosity[i] * fluid.shear_rate[i] < SleepRule::yield_share * yield;
}

/// Marks what is asleep or may sleep and has a neighbour in motion. `near(i, f)` calls f(j) for the
/// fluid near i.
template <class Near>
struct FindWoken {
  FlowView flow;
  Near near;
  char* wakes;
  SABO_HD void operator()(std::size_t i) const {
    const double speed = SleepRule::waking * flow.model.sleep.speed;
    bool is_touched = false;
    if (may_sleep(flow.model, flow.fluid.calm[i]))
      near(i, [&](std::size_t j) {
        const Vec3d& v = flow.fluid.velocity[j];
        is_touched = is_touched || dot(v, v) > speed * speed;
      });
    wakes[i] = is_touched;
  }
};

struct CountWoken {
  const char* wakes;
  SABO_HD void operator()(std::size_t i, Total& sum) const { sum.value += wakes[i]; }
};

/// Wakes those that are marked, puts the others to sleep and holds them.
struct WakeAndHold {
  FlowView flow;
  const char* wakes;
  SABO_HD void operator()(std::size_t i) const {
    double& calm = flow.fluid.calm[i];
    if (wakes[i]) calm = 0;
    if (!may_sleep(flow.model, calm)) return;
    calm = 2 * flow.model.sleep.time;
    flow.fluid.velocity[i] = {};
    flow.fluid.drag[i] = {};
  }
};

}  // namespace sabo
