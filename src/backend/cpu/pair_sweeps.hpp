#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "backend/cpu/index_run.hpp"
#include "backend/cpu/near_pairs.hpp"
#include "backend/cpu/pair_list.hpp"
#include "backend/filling.hpp"
#include "backend/pair_scale.hpp"
#include "backend/records.hpp"
#include "backend/wall_share.hpp"
#include "math/quad.hpp"
#include "math/sym3.hpp"
#include "math/vec3.hpp"
#include "physics/pair/viscous_flux.hpp"

namespace sabo {

/// What a sweep works on: particles [first, last), their neighbours and their records.
struct MotionTask {
  const PairScale* scale;
  const PairList* list;
  const MotionRecord* records;
  std::size_t fluid_count;  ///< particles below it take part in density diffusion
  std::size_t first, last;
  Sym3<double>* strain;  ///< out, this and those below by particle
  double* density_rate;
  double* diffusion_rate;  ///< share of density diffusion in it, of the fluid
};
struct ForceTask {
  const PairScale* scale;
  const PairList* list;
  const StressRecord* records;
  std::size_t first, last;
  Vec3d gravity;
  Vec3d* acceleration;     ///< out, this and those below by particle
  double* pressure_power;  ///< W/kg
  double* wall_heat;       ///< what pressure between flow and walls loses, W/kg
};

/// Pressure at boundary particles from the fluid near them (Adami et al. 2012, Eq. 27).
struct WallPressureTask {
  const PairScale* scale;
  const PairList* list;
  const FlowRecord* records;
  const std::uint32_t* rows;  ///< boundary particles, counted from the first fluid one
  std::size_t first, last;    ///< range of `rows`
  Vec3f gravity;
  float* pressure;  ///< out, this and that below by place in `rows`, Pa; 0 where no fluid is near
  float* weight;    ///< sum of W over the fluid, 1/m^D
};

/// Rate at which fluid closes in on walls under pressure (physics/pair/wall_contact.hpp).
struct WallClosingTask {
  const PairScale* scale;
  const PairList* list;
  const MotionRecord* records;
  const std::uint32_t* rows;  ///< boundary particles, counted from the first fluid one
  std::size_t first, last;    ///< range of `rows`
  // By place in `rows`; a wall without pressure hands nothing back.
  const float* pressure;
  const float* weight;
  ClosingRecord* closing;  ///< out, by particle
};

/// Acceleration by gravity and pressure, the viscous matrix and where the walls are.
struct NearForceTask {
  const PairScale* scale;
  const PairList* list;
  const FlowRecord* records;
  const MotionRecord* motion;  ///< read for artificial viscosity and moving walls only
  bool needs_motion;
  const std::uint32_t* rows;  ///< particles to work on
  std::size_t first, last;    ///< range of `rows`, all of one chunk
  Vec3d gravity;
  NearPairs::Writer* near;    ///< out
  Vec3d* acceleration;        ///< out, this and those below by particle
  float* conductance_sum;     ///< kg/s
  Sym3<float>* inverse_root;  ///< of the moments of the conductances
  double* artificial_heat;    ///< W/kg
  Filling* filling;
  WallShare* wall;
};

/// Strain rate and density rate of fluid particles over the near pairs.
struct NearMotionTask {
  const PairScale* scale;
  const NearPairs* near;
  const MotionRecord* records;
  const Vec3d* background;       ///< by particle: density gradient that diffusion leaves alone, 1/m
  const ClosingRecord* closing;  ///< by particle, of walls
  const WallGrip* grip;          ///< by particle
  const std::uint32_t* rows;
  std::size_t first, last;
  Sym3<double>* strain;    ///< out, of the whole kernel even where a part of it is empty
  double* density_rate;    ///< out
  double* diffusion_rate;  ///< out, share of density diffusion in it
  double* support;         ///< out, filled share of the kernel: 1 inside, about 1/2 at a surface
};

/// Sum of V_j s_j . grad W over the fluid near each particle, of records whose velocities are
/// shifts.
struct ShiftTask {
  const PairScale* scale;
  const NearPairs* near;
  const MotionRecord* records;
  const std::uint32_t* rows;
  std::size_t first, last;
  float* sum;  ///< out, of those of the range one after the other
};

/// Half of the gradient of the vector in the records: the first sweep of a product with the viscous
/// matrix (physics/pair/viscous_flux.hpp).
struct HalfGradientTask {
  const PairScale* scale;
  const NearPairs* near;
  const std::uint32_t* rows;
  std::size_t first, last;
  const ViscousRecord* records;
  const Sym3<float>* inverse_root;
  VelocityGradient<float>* half_gradient;  ///< out, by particle
};

/// The second: q = m p + dt (sum_j a_ij (p_i - p_j + (G_i + G_j)^T x_ij / 2) + drag p).
struct ViscousProductTask {
  const PairScale* scale;
  const NearPairs* near;
  const std::uint32_t* rows;
  std::size_t first, last;
  const ViscousRecord* records;  ///< of p and half of its gradient
  const float* mass;
  const float* drag;  ///< of the walls, kg/s
  float dt;
  Quad<float>* q;  ///< out
  double dot;      ///< out, p.q of the range
};

/// The points of some runs within a radius of a place. The arrays must reach PairList::lanes beyond
/// the runs, and so must `near` beyond what fits into it.
struct NearTask {
  const float *points_x, *points_y, *points_z;  ///< m
  const IndexRun* runs;
  int run_count;
  float x, y, z;
  float radius2;         ///< m2
  std::uint32_t offset;  ///< added to the place in the arrays, gives the index
  std::uint32_t self;    ///< index left out
  std::uint32_t* near;   ///< out, indices
};

/// The sums over pairs that take nearly all of the time, for one instruction set.
struct PairSweeps {
  const char* instruction_set;
  /// Strain rate and density rate; of boundary particles only fluid neighbours are listed.
  void (*motion)(const MotionTask&);
  /// Gravity and the acceleration by pressure and viscosity.
  void (*force)(const ForceTask&);
  void (*wall_pressure)(const WallPressureTask&);
  void (*near_force)(const NearForceTask&);
  void (*wall_closing)(const WallClosingTask&);
  void (*near_motion)(const NearMotionTask&);
  void (*shift)(const ShiftTask&);
  void (*half_gradient)(const HalfGradientTask&);
  void (*viscous_product)(ViscousProductTask&);
  /// Returns how many it wrote.
  std::size_t (*near_search)(const NearTask&);
};

/// The sweeps for every instruction set this machine has, the widest last.
const std::vector<const PairSweeps*>& all_pair_sweeps();

/// The widest of them.
inline const PairSweeps& best_pair_sweeps() { return *all_pair_sweeps().back(); }

}  // namespace sabo
