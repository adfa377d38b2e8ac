#pragma once

#include <array>
#include <string_view>

#include "base/describe.hpp"

namespace sabo {

/// Stress that boundary particles carry in the momentum sum. The paper does not say; it decides
/// the mobility: `none` transmits half of the friction.
enum class BoundaryStress {
  own,     ///< from their own strain rate, the wall at rest
  mirror,  ///< the same, the wall moving against the flow so that the surface between is at rest
  none,    ///< zero
};
template <>
struct Words<BoundaryStress> {
  static constexpr std::array<std::string_view, 3> list{"own", "mirror", "none"};
};

/// Where boundary particles have their pressure from.
enum class BoundaryPressure {
  dynamic,       ///< their own density, which obeys continuity (Crespo et al. 2007)
  extrapolated,  ///< that of the fluid near them (Adami et al. 2012)
};
template <>
struct Words<BoundaryPressure> {
  static constexpr std::array<std::string_view, 2> list{"dynamic", "extrapolated"};
};

enum class ViscousOperator {
  nested,  ///< divergence of the stress tensor, two sweeps (paper Eq. 18)
  morris,  ///< two-point Laplacian, one sweep (Morris et al. 1997)
};
template <>
struct Words<ViscousOperator> {
  static constexpr std::array<std::string_view, 2> list{"nested", "morris"};
};

/// Density gradient that diffusion works on.
enum class DiffusionForm {
  molteni,    ///< the whole gradient (paper Eq. 10; Molteni & Colagrossi 2009)
  fourtakas,  ///< without that of a fluid at rest (Fourtakas et al. 2019)
};
template <>
struct Words<DiffusionForm> {
  static constexpr std::array<std::string_view, 2> list{"molteni", "fourtakas"};
};

}  // namespace sabo
