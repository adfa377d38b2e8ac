#include <fmt/format.h>

#include "bench/parts.hpp"
#include "bench/step_clock.hpp"

namespace sabo {
namespace {

constexpr double map_over_flow = 3;

int side_of(const BenchSettings& settings) { return settings.quick ? 16 : 60; }

BenchTable share_table(const StepTimes& times, std::size_t particles) {
  BenchTable table;
  table.title = "What a step is made of";
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

}  // namespace

BenchResult bench_steps(const BenchSettings& settings) {
  BenchFlow flow = slope_flow(side_of(settings), map_over_flow, settings.threads);
  const StepTimes times = step_times(flow, settings.repeats());
  const std::size_t particles = flow.particles();
  const Samples rate = times.seconds.mapped([](double s) { return 1 / s; });
  const Samples speed = rate.mapped([&](double r) { return 1e-6 * r * particles; });

  BenchResult result;
  result.measurements.emplace_back("steps/rate", "steps/s", rate);
  result.measurements.emplace_back("steps/speed", "million particle-steps/s", speed);
  BenchTable table;
  table.title =
      fmt::format("Steps of a debris flow on rough terrain, {}", threads_text(settings.threads));
  table.header = {"fluid + boundary",         "steps/s",       "least", "most",
                  "million particle-steps/s", "steps per list"};
  table.rows = {
      {fmt::format("{} + {}", flow.backend->fluid().size(), flow.backend->boundary().size()),
       fmt::format("{:.2f}", rate.median()), fmt::format("{:.2f}", rate.low()),
       fmt::format("{:.2f}", rate.high()), fmt::format("{:.3f}", speed.median()),
       fmt::format("{:.1f}", times.steps_per_list())}};
  table.notes = {
      "A step evaluates the forces twice; all particles count, those of the ground too."};
  result.tables = {table, share_table(times, particles)};
  for (const PassSamples& pass : times.passes)
    result.measurements.emplace_back(
        fmt::format("steps/{}/time", pass.name), "ns/particle-step",
        pass.seconds.mapped([&](double s) { return 1e9 * s / static_cast<double>(particles); }));
  return result;
}

BenchResult bench_threads(const BenchSettings& settings) {
  BenchResult result;
  BenchTable table;
  table.title = "The same flow with more and more threads";
  table.header = {"threads", "steps/s", "least", "most", "times one thread", "efficiency, %"};
  std::vector<int> counts;
  for (int n = 1; n < settings.threads; n *= 2) counts.push_back(n);
  counts.push_back(settings.threads);
  double one = 0;
  for (const int threads : counts) {
    BenchFlow flow = slope_flow(side_of(settings), map_over_flow, threads);
    const Samples rate =
        step_times(flow, settings.repeats()).seconds.mapped([](double s) { return 1 / s; });
    if (threads == 1) one = rate.median();
    const double ratio = rate.median() / one;
    result.measurements.emplace_back(fmt::format("threads/{}", threads), "steps/s", rate);
    table.rows.push_back({fmt::format("{}", threads), fmt::format("{:.2f}", rate.median()),
                          fmt::format("{:.2f}", rate.low()), fmt::format("{:.2f}", rate.high()),
                          fmt::format("{:.2f}", ratio),
                          fmt::format("{:.0f}", 100 * ratio / threads)});
  }
  result.tables.push_back(std::move(table));
  return result;
}

}  // namespace sabo
