#pragma once

#include <cstdint>

namespace sabo {

// What the pair sweeps read of a neighbour, one cache line or half of one. Positions are integers
// in units of a power of two far below the spacing: their difference is exact, so that a pair far
// from the origin is as good as one near it, and half the size of doubles.

struct IntegerPlace {
  std::int32_t x, y, z;  ///< position / PairScale::unit
};

struct alignas(32) MotionRecord {
  std::int32_t x, y, z;
  float vx, vy, vz;  ///< m/s
  float excess;      ///< rho / rho0 - 1
  float volume;      ///< m / rho, m3 (m2 in two dimensions)
};
static_assert(sizeof(MotionRecord) == 32);

struct alignas(64) StressRecord {
  std::int32_t x, y, z;
  float mass;                    ///< kg
  float xx, xy, xz, yy, yz, zz;  ///< (tau - p I) / rho^2
  float vx, vy, vz;              ///< m/s
  float viscosity;               ///< Pa s, already times the strain convention
  float density;                 ///< kg/m3
  float pressure;                ///< p / rho^2, once more by itself
};
static_assert(sizeof(StressRecord) == 64);

/// For the sweeps of the implicit method, which needs no stress tensor.
struct alignas(32) FlowRecord {
  std::int32_t x, y, z;
  float mass;       ///< kg
  float pressure;   ///< p / rho0^2
  float volume;     ///< m / rho0, m3: what it was laid out with, whatever its pressure
  float viscosity;  ///< Pa s, already times the strain convention
  float density;    ///< kg/m3
};
static_assert(sizeof(FlowRecord) == 32);

/// What a wall particle hands back (physics/pair/wall_contact.hpp), per sum of weights W.
struct alignas(32) ClosingRecord {
  float rate;        ///< 1/s
  float gx, gy, gz;  ///< gradient of the sum of W, 1/m
  float unused[4];
};
static_assert(sizeof(ClosingRecord) == 32);

/// What a product with the viscous matrix reads of a neighbour (physics/pair/viscous_flux.hpp).
struct alignas(64) ViscousRecord {
  std::int32_t x, y, z;
  float vx, vy, vz;        ///< the vector that is multiplied, in m/s
  float half_gradient[9];  ///< of vx, of vy, of vz, 1/s
  float unused;
};
static_assert(sizeof(ViscousRecord) == 64);

}  // namespace sabo
