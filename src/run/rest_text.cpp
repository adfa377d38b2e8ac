#include "run/rest_text.hpp"

#include <fmt/format.h>

namespace sabo {

RestLimits rest_limits(const RunCase& run) {
  return {run.rest_time, run.rest_speed, run.rest_volume, run.rest_energy, run.rest_creep};
}

std::string motion_text(const MotionState& motion, const RunCase& run) {
  return fmt::format(
      "{:.3g} % of the volume faster than {:g} m/s, kinetic energy {:.2g} of its peak, creep "
      "{:.3g} "
      "spacings a minute",
      100 * motion.moving_share, run.rest_speed, motion.energy_share, motion.creep);
}

std::string rest_reason(const MotionState& motion, const RunCase& run) {
  return fmt::format("the flow came to rest: over {:g} s {} (limits {:g} %, {:g}, {:g})",
                     run.rest_time, motion_text(motion, run), 100 * run.rest_volume,
                     run.rest_energy, run.rest_creep);
}

}  // namespace sabo
