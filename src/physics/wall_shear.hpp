#pragma once

#include <variant>

#include "base/host_device.hpp"

namespace sabo {

/// What a wall law may depend on: the flow where it touches a wall at rest.
struct WallContact {
  double speed = 0;     ///< along the wall, m/s
  double pressure = 0;  ///< effective, at the wall, Pa
  double density = 0;   ///< kg/m3
  double gravity = 0;   ///< magnitude, m/s2
  double sticking = 0;  ///< what sticking takes, docs/method.md F6, Pa s/m
};

// A wall law gives the resistance R of a wall in Pa s/m: the shear stress on the flow is -R v with
// v the velocity along the wall. No law holds the flow back more than sticking to the wall would,
// so that a deposit comes to rest as one that sticks does. R is linear in nothing: the solver takes
// it from the last step and treats R v implicitly.

/// The fluid at the wall has the wall's velocity: the stress is that of the fluid itself.
struct NoSlip {
  SABO_HD double resistance(const WallContact& at) const { return at.sticking; }
};

/// Nothing holds the flow along the wall.
struct Slip {
  SABO_HD double resistance(const WallContact&) const { return 0; }
};

/// Dry friction with cohesion: stress c_w + tan(delta) p_eff.
struct Coulomb {
  double cohesion = 0;  ///< Pa
  double slope = 0;     ///< tan(delta)

  SABO_HD double stress(const WallContact& at) const { return cohesion + slope * at.pressure; }
  SABO_HD double resistance(const WallContact& at) const {
    const double stuck = at.sticking * at.speed;
    return stress(at) < stuck ? stress(at) / at.speed : at.sticking;
  }
};

/// Dry friction and turbulence (Voellmy 1955): stress c_w + tan(delta) p_eff + rho g v^2 / xi.
struct Voellmy {
  Coulomb friction;
  double turbulence = 500;  ///< xi, m/s2

  SABO_HD double resistance(const WallContact& at) const {
    const double drag = at.density * at.gravity * at.speed / turbulence;
    const double free = friction.resistance(at) + drag;
    return free < at.sticking ? free : at.sticking;
  }
};

/// The one list of wall laws.
using WallShear = std::variant<NoSlip, Coulomb, Voellmy, Slip>;

}  // namespace sabo
