#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "backend/cpu/pair_list.hpp"
#include "backend/cpu/records.hpp"
#include "math/sym3.hpp"
#include "math/vec3.hpp"

namespace sabo {

/// Constants of the pair sweeps in single precision.
struct PairScale {
  float unit = 1;  ///< metres per integer of position
  bool periodic = false;
  float inverse_period[3] = {0, 0, 0};  ///< 1/m; 0 for an axis that is not periodic
  Vec3f period[3];
  float h = 1;              ///< smoothing length, m
  float kernel_alpha = 1;   ///< a_D, 1/m^D
  float eta2 = 0;           ///< m2
  float rho0 = 1;           ///< kg/m3
  float two_zeta_h_c0 = 0;  ///< of density diffusion, m2/s
  Vec3f hydrostatic;        ///< of density diffusion, 1/m
  float wall_velocity_factor = 1;
  float alpha_c0_h = 0;  ///< of artificial viscosity, m2/s
  bool two_point_viscosity = false;
};

/// What a sweep works on: particles [first, last), their neighbours and their records.
struct MotionTask {
  const PairScale* scale;
  const PairList* list;
  const MotionRecord* records;
  std::size_t fluid_count;  ///< particles below it take part in density diffusion
  std::size_t first, last;
  Sym3<double>* strain;  ///< out
  double* density_rate;  ///< out
};
struct ForceTask {
  const PairScale* scale;
  const PairList* list;
  const StressRecord* records;
  std::size_t first, last;
  Vec3d gravity;
  Vec3d* acceleration;     ///< out
  double* pressure_power;  ///< out, W/kg
};

/// The two sums over pairs that take nearly all of the time, for one instruction set.
struct PairSweeps {
  const char* instruction_set;
  /// Strain rate and density rate; of boundary particles only fluid neighbours are listed.
  void (*motion)(const MotionTask&);
  /// Gravity and the acceleration by pressure and viscosity.
  void (*force)(const ForceTask&);
};

/// The sweeps for every instruction set this machine has, the widest last.
const std::vector<const PairSweeps*>& all_pair_sweeps();

/// The widest of them.
inline const PairSweeps& best_pair_sweeps() { return *all_pair_sweeps().back(); }

}  // namespace sabo
