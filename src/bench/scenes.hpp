#pragma once

#include <memory>

#include "backend/cpu/pair_sweeps.hpp"
#include "case/numerics_case.hpp"
#include "solver/domain.hpp"
#include "solver/stepper.hpp"
#include "terrain/ground.hpp"

namespace sabo {

/// A flow ready to be stepped, made by code, and whatever it stands on.
struct BenchFlow {
  std::unique_ptr<Surface> surface;
  std::unique_ptr<Ground> ground;
  std::unique_ptr<Domain> domain;  ///< null: the boundary is fixed
  std::unique_ptr<Backend> backend;
  std::unique_ptr<Stepper> stepper;

  std::size_t particles() const { return backend->fluid_count() + backend->boundary_count(); }
};

// Debris flows: a Cross fluid with Mohr-Coulomb yield, everything else as the defaults of a case.

/// A cube of `side`^3 fluid particles with nothing around it, for one instruction set: every pair
/// is one of two fluid particles, so that its arithmetic can be counted.
BenchFlow cube_flow(const PairSweeps& sweeps, Method method, int side, int threads);

/// The same cube on a floor as wide as it.
BenchFlow cube_on_floor(const PairSweeps& sweeps, Method method, int side, int threads);

/// A layer five particles deep on a level floor, periodic in plan, `side` x `side` columns.
BenchFlow layer_flow(Method method, int side, int threads);

/// The model of layers.
FlowModel layer_model(Method method);

/// A layer `cells` particles deep on a level floor, periodic in plan, `side` x `side` columns, on
/// any backend.
BenchFlow deep_layer_flow(BackendKind backend, Method method, int cells, int side);

/// A layer five particles deep and `side` x `side` columns wide that slides over rough terrain, in
/// the middle of a map of `map_side` x `map_side` cells as large as particles.
BenchFlow slope_flow(Method method, int side, int map_side, int threads);

/// A map on which the ground that slope_flow() meets is nowhere that of an edge, where columns
/// follow the tangent plane beyond it: on larger maps the flow is the same, bit by bit.
int smallest_map_side(int side);

/// Water that breaks out of a corner of a tank towards a column, the example "CaseDambreak" of
/// DualSPHysics: tank 1.6 x 0.67 x 0.4 m, water 0.4 x 0.67 x 0.3 m, walls of one layer, Wendland
/// kernel, density diffusion of Fourtakas et al. with 0.1, artificial viscosity 0.1, sound speed 20
/// sqrt(g x 0.3 m).
BenchFlow dam_break(Method method, double spacing, double h_over_dp, int threads);

/// Neighbours of a particle within 2 h on the full lattice, without itself.
int lattice_neighbours(double h_over_dp);

}  // namespace sabo
