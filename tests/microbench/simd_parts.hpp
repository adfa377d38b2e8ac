#pragma once

#include <cstddef>
#include <cstdint>

namespace sabo {

/// Parts of the pair sweeps by themselves, for one instruction set. Each works on `count` pairs, a
/// multiple of 16, and returns a sum of what it made, so that nothing is left out.
struct SimdParts {
  /// Neighbours' records of 8 floats (half a cache line) into columns.
  float (*transpose_half)(const float* records, const std::uint32_t* index, std::size_t count);
  /// Records of 16 floats (a cache line).
  float (*transpose_line)(const float* records, const std::uint32_t* index, std::size_t count);
  /// Gradient of the kernel from squared distances.
  float (*kernel)(const float* squared_distance, std::size_t count);
  /// All formulas of the motion sweep on eight columns of `count` numbers each, read in order.
  float (*motion)(const float* columns, std::size_t count);
  /// All formulas of the force sweep on sixteen such columns.
  float (*force)(const float* columns, std::size_t count);
};

}  // namespace sabo
