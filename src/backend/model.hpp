#pragma once

#include <cmath>

#include "backend/periodic.hpp"
#include "base/host_device.hpp"
#include "math/vec3.hpp"
#include "physics/equation_of_state.hpp"
#include "physics/kernel.hpp"
#include "physics/layered_viscosity.hpp"
#include "physics/rheology_list.hpp"
#include "physics/switches.hpp"
#include "physics/wall_shear.hpp"
#include "physics/yield.hpp"

namespace sabo {

/// When particles of a deposit stop taking part in the sweeps.
struct SleepRule {
  double speed = 0;   ///< slower than this a particle is calm, m/s; 0: none ever sleeps
  double time = 0.5;  ///< s for which it must have been calm
  /// A neighbour at more than this multiple of the speed wakes it.
  static constexpr double waking = 2;
  /// Share of its yield stress that a calm particle may carry.
  static constexpr double yield_share = 0.9;
};

/// A body force per mass towards a point, -strength (x - origin), for flows in free space.
struct CentralForce {
  double strength = 0;  ///< 1/s2; 0: none
  Vec3d origin;         ///< m
};

/// Everything the sweeps need to know besides the particles; during a run only the speed of sound
/// may change.
struct FlowModel {
  int dimension = 3;   ///< 3, or 2 in the x-z plane (one particle wide, y = 0)
  double spacing = 1;  ///< dp, m
  double h = 1.5;      ///< smoothing length, m
  Tait state{1000, 10};
  Vec3d gravity{0, 0, -9.81};  ///< or any uniform body force per mass, m/s2
  CentralForce central;        ///< in addition
  Rheology rheology = Newtonian{};
  MohrCoulomb yield;
  double density_diffusion = 0.1;  ///< zeta
  DiffusionForm diffusion_form = DiffusionForm::molteni;
  double artificial_viscosity = 0;  ///< Monaghan's alpha
  ViscousOperator viscous_operator = ViscousOperator::nested;
  BoundaryStress boundary_stress = BoundaryStress::own;
  BoundaryPressure boundary_pressure = BoundaryPressure::dynamic;  ///< of the method of the paper
  WallShear wall = NoSlip{};                                       ///< of the implicit method
  bool as_printed = false;           ///< with the factor 1/2 that the paper prints in Eqs. 16-17
  double crowding_tolerance = 0.03;  ///< of the implicit method: filling beyond density
  bool tension_at_surface = true;    ///< pressure may be negative there, else the fluid is torn
  bool whole_viscous_stress = true;  ///< of the implicit method: else mu grad v, right in shear
  double particle_shifting = 0;      ///< of the implicit method, see docs/method.md; 0: none
  SleepRule sleep;                   ///< of the implicit method, for laws with a yield stress
  bool walls_move = false;           ///< boundary particles may have velocities
  Periodic periodic;
  int threads = 0;  ///< 0: all

  template <class T>
  SABO_HD WendlandC2<T> kernel() const {
    return WendlandC2<T>::make(h, dimension);
  }
  SABO_HD double kernel_radius() const { return 2 * h; }
  /// Layers of boundary particles that fill the kernel of a particle at the wall.
  int wall_layers() const { return static_cast<int>(std::ceil(kernel_radius() / spacing - 1e-9)); }
  /// Regularises r^2 in denominators, m2 (0.01 h^2 as in the paper).
  SABO_HD double eta2() const { return 0.01 * h * h; }
  /// Acceleration by gravity and the central force at a place, m/s2.
  SABO_HD Vec3d body_force(const Vec3d& x) const {
    return gravity - central.strength * (x - central.origin);
  }
  /// Density gradient of the fluid at rest that diffusion leaves alone, over rho0, 1/m.
  SABO_HD Vec3d diffusion_background(const Vec3d& x) const {
    const double per_c2 = 1 / (state.c0 * state.c0);
    return diffusion_form == DiffusionForm::fourtakas ? per_c2 * body_force(x) : Vec3d{};
  }
  /// Factor on eps in Eqs. 16-17: the paper prints 1/2, which halves every viscosity.
  SABO_HD double strain_convention() const { return as_printed ? 0.5 : 1; }
  /// Factor on viscosities in the two-point form of the implicit method.
  double two_point_scale() const {
    return strain_convention() / layered_viscosity(kernel<double>(), dimension, spacing);
  }
  /// Factor on the velocity difference of pairs across the wall in viscous terms. With `mirror` the
  /// wall moves against the fluid, which doubles it; the two-point form with `none` ignores walls.
  SABO_HD double wall_velocity_factor() const {
    if (boundary_stress == BoundaryStress::mirror) return 2;
    const bool slips =
        viscous_operator == ViscousOperator::morris && boundary_stress == BoundaryStress::none;
    return slips ? 0 : 1;
  }
};

}  // namespace sabo
