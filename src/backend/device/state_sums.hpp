#pragma once

#include "backend/device/list_motion.hpp"
#include "backend/sweeps/flow_sums.hpp"

namespace sabo {

/// What is asked of all particles between two steps, in one sum: each one is waited for.
struct StateSums {
  Condition condition;
  Longest way;        // since the list was made
  double speed2 = 0;  // of particles with neighbours
  SABO_HD void join(const StateSums& other) {
    condition.join(other.condition);
    way.join(other.way);
    speed2 = larger(other.speed2, speed2);
  }
};
struct FindStateSums {
  FindCondition condition;
  FindLongestWay way;          // from null before there is a list
  const char* has_neighbours;  // likewise
  SABO_HD void operator()(std::size_t i, StateSums& sum) const {
    condition(i, sum.condition);
    if (!way.start) return;
    way(i, sum.way);
    const Vec3d& v = condition.velocity[i];
    if (has_neighbours[i]) sum.speed2 = larger(dot(v, v), sum.speed2);
  }
};

}  // namespace sabo
