// Sorting and listing of a cube of particles, one thread; items are particles.

#include <benchmark/benchmark.h>

#include "backend/cpu/neighbour_search.hpp"

namespace sabo {
namespace {

Particles cube(int side) {
  Particles particles;
  particles.resize(static_cast<std::size_t>(side) * side * side);
  std::size_t i = 0;
  for (int z = 0; z < side; ++z)
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x, ++i) {
        particles.position[i] = {1.0 * x, 1.0 * y, 1.0 * z};
        particles.id[i] = static_cast<std::uint32_t>(i);
      }
  return particles;
}

constexpr double radius = 2.3 * 1.5;  // 2 h and the skin, in spacings

void sort(benchmark::State& state) {
  Particles fluid = cube(static_cast<int>(state.range(0))), boundary;
  NeighbourSearch search({}, radius, 1);
  for ([[maybe_unused]] auto unused : state) search.sort(fluid, boundary);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(fluid.size()));
}
BENCHMARK(sort)->Arg(20)->Arg(40)->Unit(benchmark::kMillisecond);

void list_pairs(benchmark::State& state) {
  Particles fluid = cube(static_cast<int>(state.range(0))), boundary;
  NeighbourSearch search({}, radius, 1);
  search.sort(fluid, boundary);
  PairList list;
  std::vector<char> has_neighbours;
  for ([[maybe_unused]] auto unused : state)
    search.fill(fluid.position, boundary.position, list, has_neighbours);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(fluid.size()));
  state.counters["pairs"] = benchmark::Counter(
      static_cast<double>(list.pairs(0, list.size())) * static_cast<double>(state.iterations()),
      benchmark::Counter::kIsRate);
}
BENCHMARK(list_pairs)->Arg(20)->Arg(40)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace sabo
