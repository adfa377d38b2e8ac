#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "bench/measurement.hpp"
#include "bench/scenes.hpp"

namespace sabo {

/// What one pass took in each repetition.
struct PassSamples {
  std::string name;
  Samples seconds;          ///< per step
  std::uint64_t pairs = 0;  ///< over all repetitions
  double all_seconds = 0;   ///< the same
};

/// What steps of a flow took. One repetition goes from one neighbour list to the next, so that it
/// holds one list and the steps that it serves.
struct StepTimes {
  Samples seconds;  ///< per step
  std::size_t steps = 0;
  double wall = 0;     ///< over all repetitions, s
  double mean_dt = 0;  ///< simulated time of a step, s
  std::vector<PassSamples> passes;

  double steps_per_list() const {
    return static_cast<double>(steps) / static_cast<double>(seconds.values.size());
  }
};

/// Time of a step over one repetition, s; adds its steps to `steps`. A list that lasts longer than
/// `most_steps` is made anew.
double repetition(BenchFlow& flow, int most_steps, std::size_t& steps);

/// Steps of a flow, after a repetition that does not count.
StepTimes step_times(BenchFlow& flow, int repeats, int most_steps = 40);

}  // namespace sabo
