#pragma once

#include <string_view>
#include <vector>

#include "bench/report.hpp"
#include "case/numerics_case.hpp"

namespace sabo {

struct BenchSettings {
  int threads = 1;     ///< the most that are used
  bool quick = false;  ///< small scenes, few repetitions: to see that it works, not to compare
  std::vector<Method> methods{Method::fast, Method::paper};  ///< those that are measured
  BackendKind backend = BackendKind::cpu;                    ///< cpu or cuda
  double largest = 1e8;                                      ///< most fluid particles on a card

  int repeats() const { return quick ? 3 : 5; }
};

// Each measures one thing with the program's own code.

/// Peak of multiply-add in registers, for each instruction set, one core and all threads.
BenchResult bench_peak(const BenchSettings& settings);
/// Speed of the passes over pairs for each instruction set, beside that peak.
BenchResult bench_passes(const BenchSettings& settings);
/// Whole steps of a debris flow on terrain, and what share each pass has.
BenchResult bench_steps(const BenchSettings& settings);
/// The same with more and more threads.
BenchResult bench_threads(const BenchSettings& settings);
/// A layer of growing area: the time per particle must stay level.
BenchResult bench_particles(const BenchSettings& settings);
/// The same flow on a map of ten times the area: the time of a step must not change.
BenchResult bench_dry_terrain(const BenchSettings& settings);
/// Water in a tank, as other programs are measured.
BenchResult bench_dam_break(const BenchSettings& settings);

/// Speed of the passes on the graphics card, beside what it does at most, and bytes per particle,
/// for 20 thousand particles and more, as many as its memory holds.
BenchResult bench_card(const BenchSettings& settings);

/// What the ratio of the step times on the large and the small map means.
std::string_view dry_terrain_verdict(double ratio);

struct BenchPart {
  std::string_view name;
  std::string_view summary;
  BenchResult (*measure)(const BenchSettings&);
};

/// All parts for a backend, in the order in which they run.
const std::vector<BenchPart>& bench_parts(BackendKind backend);

/// This machine and this program.
BenchMachine bench_machine(const BenchSettings& settings);

}  // namespace sabo
