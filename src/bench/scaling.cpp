#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "bench/parts.hpp"
#include "bench/step_clock.hpp"

namespace sabo {

BenchResult bench_particles(const BenchSettings& settings) {
  BenchResult result;
  BenchTable table;
  table.title = fmt::format("A layer five particles deep of growing area, {}",
                            threads_text(settings.threads));
  table.header = {"fluid + boundary", "ns/particle-step", "least", "most", "least, over the first"};
  const std::vector<int> sides =
      settings.quick ? std::vector{12, 24} : std::vector{20, 40, 80, 160};
  double first = 0;
  for (const int side : sides) {
    BenchFlow flow = layer_flow(side, settings.threads);
    const double particles = static_cast<double>(flow.particles());
    const Samples time = step_times(flow, settings.repeats()).seconds.mapped([&](double s) {
      return 1e9 * s / particles;
    });
    if (first == 0) first = time.low();
    result.measurements.emplace_back(fmt::format("particles/{}", flow.particles()),
                                     "ns/particle-step", time);
    table.rows.push_back(
        {fmt::format("{} + {}", flow.backend->fluid().size(), flow.backend->boundary().size()),
         fmt::format("{:.0f}", time.median()), fmt::format("{:.0f}", time.low()),
         fmt::format("{:.0f}", time.high()), fmt::format("{:.2f}", time.low() / first)});
  }
  table.notes = {
      "Level is right: the work of a step is proportional to the particles. Noise only adds time,",
      "so the fastest repetitions are compared."};
  result.tables.push_back(std::move(table));
  return result;
}

std::string_view dry_terrain_verdict(double ratio) {
  constexpr double allowed = 0.03;
  if (ratio < 1 - allowed) return "a larger map cannot be faster, the machine is too busy to tell";
  if (ratio > 1 + allowed) return "more than the 3 % allowed, or the machine is too busy to tell";
  return "dry terrain costs nothing (within 3 %)";
}

BenchResult bench_dry_terrain(const BenchSettings& settings) {
  const int side = settings.quick ? 12 : 40;
  constexpr double narrow = 2;
  const double wide = narrow * std::sqrt(10.0);
  // One thread: the question is of work, and its time depends least on what else runs.
  BenchFlow small = slope_flow(side, narrow, 1);
  BenchFlow large = slope_flow(side, wide, 1);
  // In turns, so that what else the machine does meets both alike; they do the same steps.
  Samples small_time, large_time, ratio;
  std::size_t steps = 0;
  const int most_steps = 40;
  for (int repeat = -1; repeat < settings.repeats(); ++repeat) {
    const double a = repetition(small, most_steps, steps);
    const double b = repetition(large, most_steps, steps);
    if (repeat < 0) continue;
    small_time.values.push_back(a);
    large_time.values.push_back(b);
    ratio.values.push_back(b / a);
  }
  // Noise only ever adds time: the fastest repetitions tell most about the program.
  const double fastest = large_time.low() / small_time.low();

  BenchResult result;
  result.measurements.emplace_back("dry_terrain/ratio", "", ratio);
  result.measurements.emplace_back("dry_terrain/ratio of the fastest", "", Samples{{fastest}});
  BenchTable table;
  table.title =
      fmt::format("The same flow, {} + {} particles, on a map of ten times the area, 1 thread",
                  small.backend->fluid().size(), small.backend->boundary().size());
  table.header = {"cells of the map", "ms/step", "least", "most"};
  for (const auto& [flow, time] : {std::pair{&small, &small_time}, {&large, &large_time}})
    table.rows.push_back({fmt::format("{}", flow->surface->elevation().values.size()),
                          fmt::format("{:.2f}", 1e3 * time->median()),
                          fmt::format("{:.2f}", 1e3 * time->low()),
                          fmt::format("{:.2f}", 1e3 * time->high())});
  table.notes = {fmt::format(
      "Ratio of the fastest repetitions {:.3f}, of all {:.3f} ({:.3f} to {:.3f}): {}", fastest,
      ratio.median(), ratio.low(), ratio.high(), dry_terrain_verdict(fastest))};
  result.tables.push_back(std::move(table));
  return result;
}

}  // namespace sabo
