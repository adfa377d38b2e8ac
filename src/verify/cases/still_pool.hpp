#pragma once

#include <memory>
#include <string>

#include "backend/backend.hpp"

namespace sabo {

/// A fluid at rest over some ground, laid out on the lattice with the pressure of its weight.
struct StillPool {
  std::unique_ptr<Backend> backend;
  /// Of the surface, m: the volume of the particles over ground of the given shape.
  double level = 0;
};

// Pools about `depth` (m) deep. In two dimensions periodic along x, in three along y as well; the
// model says the rest.

/// Flat floor of boundary particles.
StillPool column_pool(const FlowModel& model, double depth);
/// Two-dimensional, with a wedge on the floor, 0.4 m high with flanks of 45 degrees.
StillPool wedge_pool(const FlowModel& model, double depth);
/// On a flat DEM, or on one whose cells, as wide as a spacing, stand up to half a spacing higher or
/// lower at random.
StillPool dem_pool(const FlowModel& model, double depth, bool is_rough);
/// Over a DEM that rises by 30 degrees along x, between walls at x = 0 and 1 m.
StillPool box_pool(const FlowModel& model, double depth);

}  // namespace sabo
