#pragma once

#include <vector>

#include "backend/body_load_sum.hpp"
#include "backend/heat_account.hpp"
#include "backend/pass_times.hpp"
#include "particles/particles.hpp"

namespace sabo {

/// What of a backend outlives a step, in the memory of the host. Pairs are not kept but listed
/// again from where the particles were when they were listed: the same list in the same order,
/// hence the same sums.
struct BackendState {
  double& sound_speed;
  Particles& fluid;
  Particles& boundary;
  std::vector<std::uint32_t>& awake;
  BodyLoadSum& loads;
  HeatAccount& heat;
  PassTimes& pass_times;
  std::vector<Vec3d>& listed;  ///< positions of the fluid when its pairs were listed

  template <class Archive>
  void archive(Archive& a) {
    a.mark("backend");
    a(sound_speed, fluid);  // as ArchivedFluid
    a(boundary, awake, loads, heat, pass_times, listed);
  }

  /// Throws RunError for what no backend with lists of this radius (m) can have written.
  void check(double list_radius) const;
};

}  // namespace sabo
