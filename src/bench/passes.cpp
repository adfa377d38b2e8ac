#include <algorithm>
#include <map>
#include <string>

#include <fmt/format.h>

#include "bench/pair_flops.hpp"
#include "bench/peak.hpp"
#include "bench/scenes.hpp"

namespace sabo {
namespace {

/// Seconds per pair of every pass over pairs, by its name.
struct PairPassSamples {
  std::vector<std::string> names;  ///< in the order of a step
  std::map<std::string, Samples> seconds;
  double listed_per_particle = 0;
};

PairPassSamples measure_passes(BenchFlow flow, const BenchSettings& settings) {
  Backend& backend = *flow.backend;
  PairPassSamples result;
  for (int repeat = -1; repeat < settings.repeats(); ++repeat) {
    backend.pass_times().clear();
    backend.find_neighbours();
    for (int step = 0; step < (settings.quick ? 1 : 3); ++step) flow.stepper->step();
    if (repeat < 0) continue;  // to warm up
    for (const PassTime& pass : backend.pass_times().passes()) {
      if (pass.pairs == 0) continue;
      const std::string name(pass.name);
      if (repeat == 0) result.names.push_back(name);
      result.seconds[name].values.push_back(pass.seconds / static_cast<double>(pass.pairs));
      if (name == "neighbour search")
        result.listed_per_particle = static_cast<double>(pass.pairs) /
                                     static_cast<double>(pass.calls * backend.fluid().size());
    }
  }
  return result;
}

/// A row, unless the pass has one: the methods share some.
void add_row(const std::string& set, const std::string& pass, const Samples& seconds, double peak,
             BenchTable& table, BenchResult& result) {
  const auto is_there = [&](const auto& row) { return row[0] == pass && row[1] == set; };
  if (std::any_of(table.rows.begin(), table.rows.end(), is_there)) return;
  const std::string name = "passes/" + set + "/" + pass;
  const Samples speed = seconds.mapped([](double s) { return 1e-6 / s; });
  const Samples nanoseconds = seconds.mapped([](double s) { return 1e9 * s; });
  result.measurements.emplace_back(name + "/speed", "million pairs/s", speed);
  result.measurements.emplace_back(name + "/time", "ns/pair", nanoseconds);
  std::vector<std::string> row{pass, set, fmt::format("{:.1f}", speed.median()),
                               fmt::format("{:.2f}", nanoseconds.median())};
  if (const double flops = flops_of_pair(pass); flops > 0) {
    const Samples share = seconds.mapped([&](double s) { return 100 * flops / s / peak; });
    result.measurements.emplace_back(name + "/share of peak", "%", share);
    row.insert(row.end(),
               {fmt::format("{:g}", flops), fmt::format("{:.1f}", 1e-9 * flops / seconds.median()),
                fmt::format("{:.0f}", share.median())});
  } else {
    row.insert(row.end(), {"-", "-", "-"});
  }
  table.rows.push_back(std::move(row));
}

}  // namespace

BenchResult bench_passes(const BenchSettings& settings) {
  BenchResult result;
  BenchTable table;
  table.title = "Passes over pairs, one core";
  table.header = {"pass", "set", "million pairs/s", "ns/pair", "flop/pair", "GFlop/s", "% of peak"};
  const auto probes = all_fma_probes();
  double pairs = 0;
  for (std::size_t k = 0; k < probes.size(); ++k) {
    const PairSweeps& sweeps = *all_pair_sweeps()[k];
    const double peak = peak_of(*probes[k], 1, settings).median();
    const std::string set = common_name(sweeps.instruction_set);
    const int side = settings.quick ? 10 : 24;
    const auto add = [&](const PairPassSamples& samples, const std::string& pass) {
      add_row(set, pass, samples.seconds.at(pass), peak, table, result);
    };
    for (const Method method : settings.methods) {
      const auto cube = measure_passes(cube_flow(sweeps, method, side, 1), settings);
      pairs = cube.listed_per_particle;
      for (const std::string& pass : cube.names) add(cube, pass);
      if (method == Method::fast)
        add(measure_passes(cube_on_floor(sweeps, method, side, 1), settings), "wall pressure");
    }
  }
  table.notes = {
      fmt::format("A cube of fluid; {:.0f} pairs a particle are listed (within 2.3 h), each from "
                  "both its sides; padding of the list is not counted.",
                  pairs),
      "The neighbour search weighs several candidates for each pair that it lists. Of method fast,",
      "near motion, shifting and viscous solve look at the pairs within 2 h only, the time of the",
      "solve is for each of its products, vectors included, and wall pressure is measured on a",
      "floor."};
  result.tables.push_back(std::move(table));
  return result;
}

}  // namespace sabo
