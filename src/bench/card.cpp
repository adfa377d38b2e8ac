#include <cmath>
#include <string>

#include <fmt/format.h>

#include "backend/cuda/graphics_card.hpp"
#include "base/error.hpp"
#include "bench/pair_flops.hpp"
#include "bench/parts.hpp"
#include "bench/step_clock.hpp"
#include "run/memory_estimate.hpp"

namespace sabo {
namespace {

constexpr int cells = 20;  // depth of the layer

/// What the card does at most.
struct CardLimits {
  GraphicsCard card;
  double bandwidth = 0;  ///< bytes/s
  double peak = 0;       ///< flop/s
};

/// Numbers of fluid particles to measure with.
std::vector<double> sizes(const BenchSettings& settings) {
  std::vector<double> counts{2e4, 1e5};
  if (!settings.quick) counts.insert(counts.end(), {1e6, 1e7, 1e8});
  std::erase_if(counts, [&](double count) { return count > settings.largest; });
  return counts;
}

/// Operations of a pair. Both sweeps of a product of the solve take the conductance anew: from the
/// places 3 and the geometry 12, with pair_viscosity 4 and conductance 7, 26; and the difference of
/// the velocities 3. The gradient 12 and its sum 9 make 50 of the first sweep; two transposed
/// gradients times x 30, added 6, times the conductance 3 and the sum 3 make 71 of the second.
double flops_on_card(std::string_view pass) {
  return pass == "viscous solve" ? 50 + 71 : flops_of_pair(pass);
}

/// Bytes that a pass asks for at each pair: the index and what it reads of the neighbour.
double bytes_of_pair(std::string_view pass) {
  if (pass == "force sweep") return 4 + 64;
  if (pass == "viscous solve") return 2 * (4 + 32 + 16) + 36;
  return 4 + 32;
}

void add_passes(Method method, std::size_t particles, const StepTimes& times,
                const CardLimits& limits, BenchTable& table, BenchResult& result) {
  for (const PassSamples& pass : times.passes) {
    if (pass.pairs == 0 || pass.name == "neighbour search") continue;
    const double rate = static_cast<double>(pass.pairs) / pass.all_seconds;
    const double flops = flops_on_card(pass.name);
    const std::string name =
        fmt::format("card/{}/{}/{}/speed", word_of(method), particles, pass.name);
    result.measurements.emplace_back(name, "billion pairs/s", Samples{{1e-9 * rate}});
    table.rows.push_back(
        {std::string(pass.name), std::string(word_of(method)), fmt::format("{}", particles),
         fmt::format("{:.2f}", 1e-9 * rate),
         flops > 0 ? fmt::format("{:.0f}", 100 * flops * rate / limits.peak) : "-",
         fmt::format("{:.0f}", 100 * bytes_of_pair(pass.name) * rate / limits.bandwidth)});
  }
}

/// One size; whether the card holds it.
bool measure(Method method, double wanted, const CardLimits& limits, BenchTable& passes,
             BenchTable& steps, BenchResult& result, int repeats) {
  const int side = static_cast<int>(std::lround(std::sqrt(wanted / cells)));
  const FlowModel model = layer_model(method);
  const double floor = std::pow(side, 2) * model.wall_layers();
  if (card_memory(model, method, wanted, floor) > limits.card.free_memory) return false;
  BenchFlow flow = deep_layer_flow(BackendKind::cuda, method, cells, side);
  const StepTimes times = step_times(flow, repeats);
  const std::size_t fluid = flow.backend->fluid_count();
  const auto all = static_cast<double>(flow.particles());
  add_passes(method, fluid, times, limits, passes, result);
  const Samples per_particle = times.seconds.mapped([&](double s) { return 1e9 * s / all; });
  const double bytes = static_cast<double>(flow.backend->device_bytes()) / all;
  const std::string name = fmt::format("card/{}/{}", word_of(method), fluid);
  result.measurements.emplace_back(name + "/step", "ns/particle-step", per_particle);
  result.measurements.emplace_back(name + "/memory", "bytes/particle", Samples{{bytes}});
  steps.rows.push_back(
      {std::string(word_of(method)), fmt::format("{} + {}", fluid, flow.backend->boundary_count()),
       fmt::format("{:.3g}", 1e3 * times.seconds.median()),
       fmt::format("{:.3g}", per_particle.median()), fmt::format("{:.1f}", times.steps_per_list()),
       fmt::format("{:.0f}", bytes)});
  return true;
}

}  // namespace

BenchResult bench_card(const BenchSettings& settings) {
  const CardLimits limits{graphics_card(), card_bandwidth(), card_peak()};
  BenchResult result;
  BenchTable passes, steps;
  passes.title = fmt::format("Passes over pairs on {}", limits.card.name);
  passes.header = {"pass", "method", "fluid", "billion pairs/s", "% of peak", "% of bandwidth"};
  passes.notes = {
      fmt::format(
          "Measured on this card: {:.1f} TFlop/s of multiply-adds in single precision, {:.0f} "
          "GB/s",
          1e-12 * limits.peak, 1e-9 * limits.bandwidth),
      "copied in its memory. The share of bandwidth counts the index and the record of each",
      "neighbour, most of which come from caches: it may be above 100 %. Pairs are those listed",
      "within 2.2 h."};
  steps.title = fmt::format("Steps of a layer {} particles deep on {}", cells, limits.card.name);
  steps.header = {"method",           "fluid + boundary", "ms/step",
                  "ns/particle-step", "steps for a list", "bytes/particle"};
  for (const Method method : settings.methods)
    for (const double wanted : sizes(settings)) try {
        if (!measure(method, wanted, limits, passes, steps, result, settings.repeats()))
          steps.notes.push_back(fmt::format("{:g} million particles do not fit into {:.0f} GB.",
                                            1e-6 * wanted, 1e-9 * limits.card.free_memory));
      } catch (const RunError& error) {  // what has been measured is worth having
        steps.notes.push_back(
            fmt::format("{:g} million particles: {}", 1e-6 * wanted, error.what()));
      }
  result.tables = {passes, steps};
  return result;
}

}  // namespace sabo
