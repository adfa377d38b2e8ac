#pragma once

#include <cstddef>
#include <string>

#include "case/case.hpp"
#include "run/scene.hpp"

namespace sabo {

/// What the first steps of a flow took on this machine.
struct CostSample {
  std::size_t fluid = 0;     ///< particles that were stepped
  std::size_t boundary = 0;  ///< the same
  double list_seconds = 0;   ///< wall time of one neighbour list: search, sort, ground
  double step_seconds = 0;   ///< wall time of a step without its list, lower quartile
  double dt = 0;             ///< of the last step, s
  double speed = 0;          ///< of the fastest particle in it, m/s
  double sound_speed = 0;    ///< in it, m/s
};

/// What is known of a run without running it.
struct CostOutlook {
  Method method = Method::fast;
  double duration = 0;       ///< s
  double h = 0;              ///< smoothing length, m
  double cfl = 0;            ///< of the acoustic time step
  double slowest_sound = 0;  ///< m/s
  double sound_factor = 0;   ///< sound speed over the fastest speed, if it follows; else 0
  double list_reach = 0;     ///< way that a particle may go before the list is renewed, m
  double top_speed = 0;      ///< bound of the fastest speed, m/s; 0: nothing is known
  std::size_t fluid = 0;     ///< particles of the flow, mean over the run
  double latest_ground = 0;  ///< boundary particles at the end
};

struct CostForecast {
  double seconds = 0;  ///< wall time of the run
  double steps = 0;
  double dt = 0;  ///< mean, s
  int threads = 1;
  bool is_busy = false;  ///< other programs ran while it was measured
  bool on_card = false;  ///< a graphics card runs it
};

/// How far the truth may be from the forecast, either way.
inline constexpr double forecast_factor = 2;

/// Extrapolates over the duration. The model:
/// - The fastest speed is a third of its bound, or what it was in the sample if that is more.
/// - The time step is the acoustic one at that speed, and at the sound speed that belongs to it; no
///   longer than that of the sample where another limit ruled that.
/// - A list lasts until the fastest particle has gone `list_reach`.
/// - Time grows with the particles, of which one of the ground takes a quarter of what one of the
///   flow takes, for most of the ground has no flow within reach; the ground grows evenly.
/// Writing results is not counted, and the run is not expected to come to rest.
CostForecast forecast(const CostSample& sample, const CostOutlook& outlook);

/// Bound of the speed of a mass that slides down the path of the scene against friction alone: with
/// the energy head H = z0 - z - s tan(phi) at the station s (Heim 1932), the greatest sqrt(2 g H),
/// at most 30 m/s; and at most numerics.reference_speed where that is given.
double speed_bound(const Case& c, const Scene& scene);

/// Steps the first moments of the case in memory, for a second or two or up to 2 % of the duration,
/// and extrapolates. Of a large release only a part is stepped; without one, what lies in front of
/// the first inflow if it flows on as at its peak. Throws RunError if the flow fails.
CostForecast measured_forecast(const Case& c, const Scene& scene);

/// "about 6 min on 2 threads (3 to 12 min), 33 thousand steps of 9 ms"; on a busy machine also
/// that.
std::string forecast_text(const CostForecast& forecast);

}  // namespace sabo
