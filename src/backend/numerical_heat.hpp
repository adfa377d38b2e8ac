#pragma once

namespace sabo {

/// What the implicit scheme itself has taken from the energy of the flow, J; negative what it gave.
/// Of the explicit method it stays zero: there artificial viscosity counts as dissipation and
/// density diffusion as unaccounted for.
struct NumericalHeat {
  double artificial_viscosity = 0;
  double density_diffusion = 0;
  double density_hold = 0;  ///< density held to the places of the particles
  double sound_speed = 0;   ///< compression at the same pressure with another speed of sound

  double total() const {
    return artificial_viscosity + density_diffusion + density_hold + sound_speed;
  }
};

}  // namespace sabo
