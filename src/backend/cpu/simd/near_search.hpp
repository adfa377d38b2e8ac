#pragma once

#include "backend/cpu/pair_sweeps.hpp"
#include "backend/cpu/simd/lanes.hpp"

namespace sabo {
namespace HWY_NAMESPACE {

/// Writes the indices of a run of points that lie within a radius, see NearTask.
std::size_t near_search(const NearTask& task);

}  // namespace HWY_NAMESPACE
}  // namespace sabo
