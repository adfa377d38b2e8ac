#pragma once

#include <cmath>
#include <cstdint>

#include "backend/model.hpp"

namespace sabo {

/// Constants of the pair sweeps in single precision.
struct PairScale {
  float unit = 1;  ///< metres per integer of position
  bool periodic = false;
  float inverse_period[3] = {0, 0, 0};  ///< 1/m; 0 for an axis that is not periodic
  Vec3f period[3];
  float h = 1;                  ///< smoothing length, m
  float kernel_alpha = 1;       ///< a_D, 1/m^D
  float eta2 = 0;               ///< m2
  float rho0 = 1;               ///< kg/m3
  float two_zeta_h_c0 = 0;      ///< of density diffusion, m2/s
  Vec3f hydrostatic;            ///< of density diffusion, at the origin of the central force, 1/m
  float central = 0;            ///< strength of the central force, 1/s2
  Vec3f central_origin;         ///< from the place of integers 0, m
  float hydrostatic_slope = 0;  ///< by which `hydrostatic` falls from that origin on, 1/m2
  float wall_velocity_factor = 1;
  float alpha_c0_h = 0;  ///< of artificial viscosity, m2/s
  bool two_point_viscosity = false;
  double two_point_scale = 1;  ///< on the viscosities of the implicit method
  int dimension = 3;
  bool whole_viscous_stress = true;

  PairScale() = default;
  /// `centre` (m) becomes the place of integers 0; all particles stay within `reach` (m) of it.
  PairScale(const FlowModel& model, const Vec3d& centre, double reach) {
    unit = static_cast<float>(std::ldexp(1.0, static_cast<int>(std::ceil(std::log2(reach))) - 30));
    periodic = model.periodic.any();
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3d& p = model.periodic.period[axis];
      period[axis] = in_single(p);
      inverse_period[axis] = model.periodic.on(axis) ? float(1 / Periodic::along(p, axis)) : 0.0f;
    }
    central = float(model.central.strength);
    central_origin = in_single(model.central.origin - centre);
    const auto kernel = model.kernel<float>();
    h = kernel.h;
    kernel_alpha = kernel.alpha;
    eta2 = float(model.eta2());
    rho0 = float(model.state.rho0);
    set_sound_speed(model);
    wall_velocity_factor = float(model.wall_velocity_factor());
    dimension = model.dimension;
    whole_viscous_stress = model.whole_viscous_stress;
    two_point_viscosity = model.viscous_operator == ViscousOperator::morris;
    two_point_scale = model.two_point_scale();
  }

  /// What depends on the sound speed, which may change from step to step.
  void set_sound_speed(const FlowModel& model) {
    const double c0 = model.state.c0;
    two_zeta_h_c0 = float(2 * model.density_diffusion * model.h * c0);
    hydrostatic = in_single(model.diffusion_background(model.central.origin));
    if (model.diffusion_form == DiffusionForm::fourtakas)
      hydrostatic_slope = float(model.central.strength / (c0 * c0));
    alpha_c0_h = float(model.artificial_viscosity * c0 * model.h);
  }

  /// From the origin of the central force to integer positions, m.
  SABO_HD Vec3f from_origin(std::int32_t x, std::int32_t y, std::int32_t z) const {
    return unit * Vec3f{float(x), float(y), float(z)} - central_origin;
  }
};

}  // namespace sabo
