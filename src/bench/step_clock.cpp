#include "bench/step_clock.hpp"

#include <chrono>

namespace sabo {
namespace {

std::uint64_t lists_made(BenchFlow& flow) {
  return flow.backend->pass_times()["neighbour search"].calls;
}

/// The entry of a pass, made if there is none.
PassSamples& entry_of(std::string_view name, std::vector<PassSamples>& passes) {
  for (PassSamples& pass : passes)
    if (pass.name == name) return pass;
  passes.push_back({std::string(name), {}});
  return passes.back();
}

}  // namespace

double repetition(BenchFlow& flow, int most_steps, std::size_t& steps) {
  using Clock = std::chrono::steady_clock;
  const std::uint64_t lists = lists_made(flow);
  const auto start = Clock::now();
  int count = 0;
  while (lists_made(flow) == lists) {
    if (count == most_steps) {
      flow.backend->find_neighbours();
      break;
    }
    flow.stepper->step();
    ++count;
  }
  const std::chrono::duration<double> time = Clock::now() - start;
  steps += static_cast<std::size_t>(count);
  return time.count() / count;
}

StepTimes step_times(BenchFlow& flow, int repeats, int most_steps) {
  StepTimes times;
  repetition(flow, most_steps, times.steps);
  times.steps = 0;
  const double start = flow.stepper->time();
  for (int repeat = 0; repeat < repeats; ++repeat) {
    flow.backend->pass_times().clear();
    std::size_t steps = 0;
    times.seconds.values.push_back(repetition(flow, most_steps, steps));
    times.steps += steps;
    times.wall += times.seconds.values.back() * static_cast<double>(steps);
    for (const PassTime& pass : flow.backend->pass_times().passes()) {
      PassSamples& entry = entry_of(pass.name, times.passes);
      entry.seconds.values.push_back(pass.seconds / static_cast<double>(steps));
      entry.all_seconds += pass.seconds;
      entry.pairs += pass.pairs;
    }
  }
  times.mean_dt = (flow.stepper->time() - start) / static_cast<double>(times.steps);
  return times;
}

}  // namespace sabo
