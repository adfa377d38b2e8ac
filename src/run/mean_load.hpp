#pragma once

#include <vector>

#include "analysis/load_profile.hpp"
#include "math/vec3.hpp"

namespace sabo {

/// What a structure had to bear since the row before.
struct MeanLoad {
  Vec3d force;                            ///< N
  Vec3d moment;                           ///< about the middle of the base, N m
  std::vector<LoadProfile::Bin> profile;  ///< over the height
  Vec3d impulse;                          ///< since the start, N s
  double peak = 0;  ///< since the start: greatest horizontal force as a mean over the filter, N
  double peak_time = 0;  ///< end of its window, s
};

}  // namespace sabo
