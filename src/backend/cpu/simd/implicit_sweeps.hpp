#pragma once

#include "backend/cpu/pair_sweeps.hpp"
#include "backend/cpu/simd/lanes.hpp"

namespace sabo {
namespace HWY_NAMESPACE {

// The sweeps of the implicit method, see the tasks in PairSweeps.
void wall_pressure(const WallPressureTask& task);
void wall_closing(const WallClosingTask& task);
void near_force(const NearForceTask& task);
void near_motion(const NearMotionTask& task);
void shift(const ShiftTask& task);
// In viscous_sweeps.cpp.
void half_gradient(const HalfGradientTask& task);
void viscous_product(ViscousProductTask& task);

}  // namespace HWY_NAMESPACE
}  // namespace sabo
