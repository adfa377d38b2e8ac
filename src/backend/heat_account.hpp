#pragma once

#include "base/host_device.hpp"

namespace sabo {

/// What the scheme itself has taken from the energy of the flow, J; negative what it gave.
struct NumericalHeat {
  double artificial_viscosity = 0;  ///< method fast; with paper it is a part of viscosity
  double density_diffusion = 0;
  double density_hold = 0;  ///< fast: density held to the places of the particles, and tearing
  double shifting = 0;      ///< fast: particles shifted to more even places
  double sound_speed = 0;   ///< fast: compression at the same pressure with another speed of sound
  double walls = 0;         ///< pressure against walls, which give back what it took only in part;
                            ///< fast: and what force and compression differ by over a step;
                            ///< paper: with what walls keep as compression of their own

  double total() const {
    return artificial_viscosity + density_diffusion + density_hold + shifting + sound_speed + walls;
  }
};

/// What has been taken from a flow since its start.
struct HeatAccount {
  double viscosity = 0;  ///< by viscosity within the flow and by walls, J
  NumericalHeat numerical;
};

/// Enters what has been summed up.
struct EnterHeat {
  HeatAccount* account;
  template <class Heat>
  SABO_HD void operator()(const Heat& heat) const {
    heat.enter(*account);
  }
};

}  // namespace sabo
