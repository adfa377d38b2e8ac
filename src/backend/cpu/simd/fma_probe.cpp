// Compiled once for each instruction set (src/CMakeLists.txt), SABO_FMA_PROBE naming the result.

#include "backend/cpu/fma_probe.hpp"

#include "backend/cpu/simd/lanes.hpp"

namespace sabo {
namespace HWY_NAMESPACE {
namespace {

/// Independent chains. Two units with a latency of four or five cycles want ten; with the two
/// operands they fit into the sixteen registers of SSE and AVX2.
constexpr std::size_t chains = 12;
constexpr std::size_t unrolled = 4;

float run_fma_probe(std::size_t rounds) {
  const Lanes::Tag tag;
  // x -> a x + b settles at b / (1 - a) = 1: no overflow, no denormals. The factor depends on
  // `rounds` and every chain starts elsewhere, so that the compiler can leave none of them out.
  const float a = 0.5f + 1e-3f * static_cast<float>(rounds % 2);
  const Lanes::Vector factor = hn::Set(tag, a);
  const Lanes::Vector term = hn::Set(tag, 1 - a);
  const auto start = [tag](float x) { return hn::Set(tag, x); };
  Lanes::Vector x0 = start(0), x1 = start(1), x2 = start(2), x3 = start(3), x4 = start(4);
  Lanes::Vector x5 = start(5), x6 = start(6), x7 = start(7), x8 = start(8), x9 = start(9);
  Lanes::Vector x10 = start(10), x11 = start(11);
  for (std::size_t round = 0; round < rounds; ++round) {
    for (std::size_t k = 0; k < unrolled; ++k) {
      x0 = hn::MulAdd(x0, factor, term);
      x1 = hn::MulAdd(x1, factor, term);
      x2 = hn::MulAdd(x2, factor, term);
      x3 = hn::MulAdd(x3, factor, term);
      x4 = hn::MulAdd(x4, factor, term);
      x5 = hn::MulAdd(x5, factor, term);
      x6 = hn::MulAdd(x6, factor, term);
      x7 = hn::MulAdd(x7, factor, term);
      x8 = hn::MulAdd(x8, factor, term);
      x9 = hn::MulAdd(x9, factor, term);
      x10 = hn::MulAdd(x10, factor, term);
      x11 = hn::MulAdd(x11, factor, term);
    }
  }
  const Lanes low = Lanes(x0) + Lanes(x1) + Lanes(x2) + Lanes(x3) + Lanes(x4) + Lanes(x5);
  const Lanes high = Lanes(x6) + Lanes(x7) + Lanes(x8) + Lanes(x9) + Lanes(x10) + Lanes(x11);
  return sum(low + high);
}

}  // namespace
}  // namespace HWY_NAMESPACE

extern const FmaProbe SABO_FMA_PROBE;
const FmaProbe SABO_FMA_PROBE{
    hwy::TargetName(HWY_STATIC_TARGET),
    2 * HWY_NAMESPACE::chains* HWY_NAMESPACE::unrolled* HWY_NAMESPACE::Lanes::count,
    HWY_NAMESPACE::run_fma_probe};

}  // namespace sabo
