#pragma once

#include <cstdint>
#include <memory>

#include "backend/backend.hpp"
#include "case/numerics_case.hpp"

namespace sabo {

// Flows laid out by hand on the lattice of the spacing dp, for measurements and cases with a known
// solution.

/// Appends a particle of one lattice cell with the reference density of the model.
void add_particle(Particles& particles, const FlowModel& model, const Vec3d& position,
                  const Vec3d& velocity = {});

/// Half-open ranges of lattice cells.
struct Cells {
  int x0, x1, y0, y1, z0, z1;
};

/// Fills cells of the lattice, one particle in the middle of each. In two dimensions y is 0.
void add_block(Particles& particles, const FlowModel& model, const Cells& cells);

/// An upright box, m. In two dimensions its y means nothing.
struct Box {
  Vec3d low, high;
};

/// Fills a box with particles of the number of a body (0: none): along each axis as many as come
/// nearest to the spacing, stretched so that their cells fill the box exactly. Masses are those of
/// the cells.
void add_box(Particles& particles, const FlowModel& model, const Box& box, std::uint16_t body = 0);

/// The same with the density of fluid at rest whose level surface is the top of the box.
void add_still_box(Particles& fluid, const FlowModel& model, const Box& box);

/// Walls around an upright box, open at the top; in two dimensions without walls across y.
struct Tank {
  Box inner;
  int layers = 0;  ///< of the walls; 0: as many as fill the kernel
  void add_to(Particles& boundary, const FlowModel& model) const;
};

/// Makes those particles of walls and floors that lie under a box the foundation of its body, see
/// Ground.
void mark_foundation(Particles& boundary, const Box& box, std::uint16_t body);

/// Gives the fluid the density of one at rest whose level surface is at the height `surface` (m):
/// under the gravity across it, on an incline its part across the bed.
void make_hydrostatic(Backend& backend, double surface);

/// A layer of fluid on a floor at z = 0, or between that floor and a lid, periodic in x and, in
/// three dimensions, in y. The gravity of the model is any vector: a tilted one makes an incline.
struct Layer {
  FlowModel model;
  int cells = 10;        ///< thickness of the layer
  int period = 8;        ///< in cells
  bool has_lid = false;  ///< boundary particles above as below

  std::unique_ptr<Backend> make(BackendKind kind = BackendKind::cpu) const;
  /// The two parts of that.
  FlowModel periodic_model() const;
  void fill(Backend& backend) const;
};

}  // namespace sabo
