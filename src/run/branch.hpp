#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "case/case.hpp"
#include "particles/particles.hpp"
#include "run/scene.hpp"

namespace sabo {

/// Where a run of a changed case starts from.
struct BranchOrigin {
  std::filesystem::path run_folder;
  double time = 0;  ///< wanted, s
};

/// A flow on its way.
struct BranchStart {
  double time = 0;  ///< s
  Particles fluid;
};

/// The state of a run at its latest checkpoint not after `origin.time`, but for an interval of its
/// series. Throws CaseError when there is none, when the case differs in more than may change, and
/// when part of the flow would be inside of what is new. `tell` hears which state was taken, and of
/// damaged checkpoints.
BranchStart branch_start(const Case& c, const Scene& scene, const BranchOrigin& origin,
                         const std::function<void(const std::string&)>& tell);

}  // namespace sabo
