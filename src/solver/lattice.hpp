#pragma once

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
};

}  // namespace sabo
