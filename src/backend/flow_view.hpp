#pragma once

#include "backend/filling.hpp"
#include "backend/model.hpp"
#include "backend/shift.hpp"
#include "backend/wall_share.hpp"
#include "math/sym3.hpp"
#include "particles/particle_view.hpp"
#include "physics/half_space.hpp"

namespace sabo {

/// What the sweeps over single particles work on: the model and where the arrays are, in the memory
/// of the host or of a device. Arrays over all particles hold the fluid first; an array that no
/// sweep of the method at hand reads may be missing.
struct FlowView {
  FlowModel model;
  double yield_slope = 0;  ///< of the model's yield: a tangent that no particle has to take again
  const HalfSpace* half_space = nullptr;
  std::size_t fluid_count = 0;
  ParticleView fluid, boundary;

  // Results of the last evaluation.
  Sym3<double>* strain = nullptr;    ///< eps = grad v + (grad v)^T, 1/s
  Sym3<double>* stress = nullptr;    ///< (tau - p I) / rho^2; without tau for two-point viscosity
  double* density_rate = nullptr;    ///< kg/m3/s
  Vec3d* acceleration = nullptr;     ///< fluid only, as all below; m/s2
  double* pressure_power = nullptr;  ///< v times acceleration by pressure, W/kg
  double* wall_heat = nullptr;       ///< what pressure between flow and walls loses, W/kg
  double* diffusion_rate = nullptr;  ///< share of density diffusion in density_rate
  char* has_neighbours = nullptr;

  // Of the implicit method.
  WallShare* wall = nullptr;
  double* wall_drag = nullptr;  ///< area times resistance, kg/s
  WallGrip* grip = nullptr;
  double* support = nullptr;    ///< share of the kernel that has neighbours, by its gradient
  Vec3d* background = nullptr;  ///< density gradient that diffusion leaves alone, 1/m
  Filling* filling = nullptr;
  double* artificial_heat = nullptr;  ///< W/kg
  Shift* shift = nullptr;             ///< of the last step
};

/// Points a view at the arrays of a backend, which have the same names wherever they live.
struct FlowArrays {
  template <class Backend>
  static void point(FlowView& flow, Backend& of) {
    flow.strain = of.strain_.data();
    flow.stress = of.stress_.data();
    flow.density_rate = of.density_rate_.data();
    flow.acceleration = of.acceleration_.data();
    flow.pressure_power = of.pressure_power_.data();
    flow.wall_heat = of.wall_heat_.data();
    flow.diffusion_rate = of.diffusion_rate_.data();
    flow.has_neighbours = of.has_neighbours_.data();
    flow.wall = of.wall_share_.data();
    flow.wall_drag = of.wall_drag_.data();
    flow.grip = of.wall_grip_.data();
    flow.support = of.support_.data();
    flow.background = of.background_.size() > 0 ? of.background_.data() : nullptr;
    flow.filling = of.filling_.data();
    flow.artificial_heat = of.artificial_heat_.size() > 0 ? of.artificial_heat_.data() : nullptr;
    flow.shift = of.shift_.data();
  }
};

/// Particles that a sweep works on.
struct RowList {
  const std::uint32_t* index = nullptr;
  std::size_t count = 0;
};

/// f(i) at the k-th of some rows.
template <class F>
struct AtRow {
  const std::uint32_t* index;
  F f;
  SABO_HD void operator()(std::size_t k) const { f(std::size_t{index[k]}); }
};

}  // namespace sabo
