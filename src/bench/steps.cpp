#include <fmt/format.h>

#include "bench/parts.hpp"
#include "bench/step_clock.hpp"

namespace sabo {
namespace {

int side_of(const BenchSettings& settings) { return settings.quick ? 16 : 60; }

BenchFlow flow_of(Method method, int threads, const BenchSettings& settings) {
  const int side = side_of(settings);
  return slope_flow(method, side, smallest_map_side(side), threads);
}

BenchTable share_table(Method method, const StepTimes& times, std::size_t particles) {
  BenchTable table;
  table.title = fmt::format("What a step is made of, method {}", word_of(method));
  table.header = {"pass", "share, %", "ns/particle-step", "million pairs/s"};
  const double visits = static_cast<double>(times.steps) * static_cast<double>(particles);
  double rest = times.wall;
  const auto add = [&](std::string_view name, double seconds, std::uint64_t pairs) {
    table.rows.push_back({std::string(name), fmt::format("{:.1f}", 100 * seconds / times.wall),
                          fmt::format("{:.1f}", 1e9 * seconds / visits),
                          pairs > 0 ? fmt::format("{:.1f}", 1e-6 * pairs / seconds) : "-"});
    rest -= seconds;
  };
  for (const PassSamples& pass : times.passes) add(pass.name, pass.all_seconds, pass.pairs);
  add("everything else", rest, 0);
  return table;
}

/// One method: a row of `table`, its own table of passes.
void measure_steps(Method method, const BenchSettings& settings, BenchTable& table,
                   BenchResult& result) {
  BenchFlow flow = flow_of(method, settings.threads, settings);
  const StepTimes times = step_times(flow, settings.repeats());
  const std::size_t particles = flow.particles();
  const Samples rate = times.seconds.mapped([](double s) { return 1 / s; });
  const Samples speed = rate.mapped([&](double r) { return 1e-6 * r * particles; });
  const Samples simulated = rate.mapped([&](double r) { return 1e3 * r * times.mean_dt; });

  const std::string name = fmt::format("steps/{}/", word_of(method));
  result.measurements.emplace_back(name + "rate", "steps/s", rate);
  result.measurements.emplace_back(name + "speed", "million particle-steps/s", speed);
  result.measurements.emplace_back(name + "simulated", "ms of flow/s", simulated);
  table.rows.push_back(
      {std::string(word_of(method)),
       fmt::format("{} + {}", flow.backend->fluid().size(), flow.backend->boundary().size()),
       fmt::format("{:.2f}", rate.median()), fmt::format("{:.2f}", rate.low()),
       fmt::format("{:.2f}", rate.high()), fmt::format("{:.3f}", speed.median()),
       fmt::format("{:.1f}", times.steps_per_list()), fmt::format("{:.2f}", 1e3 * times.mean_dt),
       fmt::format("{:.1f}", simulated.median())});
  result.tables.push_back(share_table(method, times, particles));
  for (const PassSamples& pass : times.passes)
    result.measurements.emplace_back(
        fmt::format("{}{}/time", name, pass.name), "ns/particle-step",
        pass.seconds.mapped([&](double s) { return 1e9 * s / static_cast<double>(particles); }));
}

/// One method: rows of `table`.
void measure_threads(Method method, const BenchSettings& settings, BenchTable& table,
                     BenchResult& result) {
  std::vector<int> counts;
  for (int n = 1; n < settings.threads; n *= 2) counts.push_back(n);
  counts.push_back(settings.threads);
  double one = 0;
  for (const int threads : counts) {
    BenchFlow flow = flow_of(method, threads, settings);
    const Samples rate =
        step_times(flow, settings.repeats()).seconds.mapped([](double s) { return 1 / s; });
    if (threads == 1) one = rate.median();
    const double ratio = rate.median() / one;
    result.measurements.emplace_back(fmt::format("threads/{}/{}", word_of(method), threads),
                                     "steps/s", rate);
    table.rows.push_back({std::string(word_of(method)), fmt::format("{}", threads),
                          fmt::format("{:.2f}", rate.median()), fmt::format("{:.2f}", rate.low()),
                          fmt::format("{:.2f}", rate.high()), fmt::format("{:.2f}", ratio),
                          fmt::format("{:.0f}", 100 * ratio / threads)});
  }
}

}  // namespace

BenchResult bench_steps(const BenchSettings& settings) {
  BenchResult result;
  BenchTable table;
  table.title =
      fmt::format("Steps of a debris flow on rough terrain, {}", threads_text(settings.threads));
  table.header = {"method",      "fluid + boundary",         "steps/s",        "least",
                  "most",        "million particle-steps/s", "steps per list", "ms of flow a step",
                  "ms of flow/s"};
  table.notes = {
      "All particles count, those of the ground too. Method paper evaluates the forces twice a",
      "step; what counts for a run is the last column. This flow has just started, and its sound",
      "speed is that of a reference speed of 15 m/s."};
  for (const Method method : settings.methods) measure_steps(method, settings, table, result);
  result.tables.insert(result.tables.begin(), std::move(table));
  return result;
}

BenchResult bench_threads(const BenchSettings& settings) {
  BenchResult result;
  BenchTable table;
  table.title = "The same flow with more and more threads";
  table.header = {"method", "threads",          "steps/s",      "least",
                  "most",   "times one thread", "efficiency, %"};
  for (const Method method : settings.methods) measure_threads(method, settings, table, result);
  result.tables.push_back(std::move(table));
  return result;
}

}  // namespace sabo
