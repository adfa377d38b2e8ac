#include "bench/parts.hpp"

#include <cstdlib>

#include <fmt/format.h>
#include <omp.h>

#include "backend/cpu/pair_sweeps.hpp"
#include "base/version.hpp"
#include "bench/peak.hpp"
#include "io/output/cpu_name.hpp"
#include "run/manifest.hpp"

namespace sabo {

const std::vector<BenchPart>& bench_parts(BackendKind backend) {
  static const std::vector<BenchPart> card_parts{
      {"card", "passes on the graphics card, by number of particles", bench_card},
  };
  if (backend == BackendKind::cuda) return card_parts;
  static const std::vector<BenchPart> parts{
      {"peak", "most multiplications and additions of a core, by instruction set", bench_peak},
      {"passes", "speed of the passes over pairs, by instruction set", bench_passes},
      {"steps", "whole steps of a debris flow, and the share of each pass", bench_steps},
      {"threads", "the same with 1, 2, 4, ... threads", bench_threads},
      {"particles", "time per particle while the flow grows in area", bench_particles},
      {"dry_terrain", "the same flow on a map of ten times the area", bench_dry_terrain},
      {"dam_break", "water in a tank, as other programs are measured", bench_dam_break},
  };
  return parts;
}

BenchMachine bench_machine(const BenchSettings& settings) {
  BenchMachine machine;
  machine.version = build_version;
  machine.compiler = fmt::format("{}, {}", build_compiler, build_type);
  machine.cpu = cpu_name();
  machine.instruction_set = common_name(best_pair_sweeps().instruction_set);
  machine.threads = settings.threads;
  machine.cores = omp_get_num_procs();
  if (getloadavg(&machine.load, 1) != 1) machine.load = 0;
  machine.date = utc_now();
  return machine;
}

}  // namespace sabo
