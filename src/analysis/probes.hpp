#pragma once

#include "particles/particles.hpp"
#include "physics/kernel.hpp"

namespace sabo {

// What instruments fixed in space would show of a flow.

/// A pressure gauge at a point on or near a wall, Pa: the mean of the fluid within the kernel, each
/// particle's pressure carried to the point along the gravity (m/s2),
///   p = sum V W (p_j + rho_j g.x_pj) / sum V W
/// (Shepard 1968; Adami, Hu & Adams 2012, Eq. 27). Exact for fluid at rest. 0 where it is dry.
double pressure_at(const Particles& fluid, const Vec3d& point, const WendlandC2<double>& kernel,
                   const Vec3d& gravity);

/// A wire gauge upwards from a point on a floor, m: how much of the line is in the fluid, that is
/// where sum V W > 1/2. Where the fluid has no holes that is the height of its free surface; spray
/// above it counts by its own length. Below the point the fluid goes on as its mirror image, so
/// that the floor takes nothing away; a wall beside the gauge does. A film thinner than about a
/// spacing may not be seen.
double water_height(const Particles& fluid, const Vec3d& point, const WendlandC2<double>& kernel);

}  // namespace sabo
