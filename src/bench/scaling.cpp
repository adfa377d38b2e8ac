#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "bench/parts.hpp"
#include "bench/step_clock.hpp"

namespace sabo {
namespace {

/// One method: rows of `table`.
void measure_particles(Method method, const BenchSettings& settings, BenchTable& table,
                       BenchResult& result) {
  const std::vector<int> sides =
      settings.quick ? std::vector{12, 24} : std::vector{20, 40, 80, 160};
  double first = 0;
  for (const int side : sides) {
    BenchFlow flow = layer_flow(method, side, settings.threads);
    const double particles = static_cast<double>(flow.particles());
    const Samples time = step_times(flow, settings.repeats()).seconds.mapped([&](double s) {
      return 1e9 * s / particles;
    });
    if (first == 0) first = time.low();
    result.measurements.emplace_back(
        fmt::format("particles/{}/{}", word_of(method), flow.particles()), "ns/particle-step",
        time);
    table.rows.push_back(
        {std::string(word_of(method)),
         fmt::format("{} + {}", flow.backend->fluid().size(), flow.backend->boundary().size()),
         fmt::format("{:.0f}", time.median()), fmt::format("{:.0f}", time.low()),
         fmt::format("{:.0f}", time.high()), fmt::format("{:.2f}", time.low() / first)});
  }
}

}  // namespace

BenchResult bench_particles(const BenchSettings& settings) {
  BenchResult result;
  BenchTable table;
  table.title = fmt::format("A layer five particles deep of growing area, {}",
                            threads_text(settings.threads));
  table.header = {"method", "fluid + boundary",     "ns/particle-step", "least",
                  "most",   "least, over the first"};
  for (const Method method : settings.methods) measure_particles(method, settings, table, result);
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

namespace {

/// One method: two rows and a note of `table`.
void measure_dry_terrain(Method method, const BenchSettings& settings, BenchTable& table,
                         BenchResult& result) {
  const int side = settings.quick ? 12 : 40;
  const int narrow = smallest_map_side(side);
  const int wide = static_cast<int>(std::lround(narrow * std::sqrt(10.0) / 2)) * 2;
  // One thread: the question is of work, and its time depends least on what else runs.
  BenchFlow small = slope_flow(method, side, narrow, 1);
  BenchFlow large = slope_flow(method, side, wide, 1);
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

  const std::string name = fmt::format("dry_terrain/{}/", word_of(method));
  result.measurements.emplace_back(name + "ratio", "", ratio);
  result.measurements.emplace_back(name + "ratio of the fastest", "", Samples{{fastest}});
  for (const auto& [flow, time] : {std::pair{&small, &small_time}, {&large, &large_time}})
    table.rows.push_back(
        {std::string(word_of(method)), fmt::format("{}", flow->surface->elevation().values.size()),
         fmt::format("{} + {}", flow->backend->fluid().size(), flow->backend->boundary().size()),
         fmt::format("{:.2f}", 1e3 * time->median()), fmt::format("{:.2f}", 1e3 * time->low()),
         fmt::format("{:.2f}", 1e3 * time->high())});
  table.notes.push_back(fmt::format(
      "{}: ratio of the fastest repetitions {:.3f}, of all {:.3f} ({:.3f} to {:.3f}): {}",
      word_of(method), fastest, ratio.median(), ratio.low(), ratio.high(),
      dry_terrain_verdict(fastest)));
}

}  // namespace

BenchResult bench_dry_terrain(const BenchSettings& settings) {
  BenchResult result;
  BenchTable table;
  table.title = "The same flow on a map of ten times the area, 1 thread";
  table.header = {"method", "cells of the map", "fluid + boundary", "ms/step", "least", "most"};
  for (const Method method : settings.methods) measure_dry_terrain(method, settings, table, result);
  result.tables.push_back(std::move(table));
  return result;
}

}  // namespace sabo
