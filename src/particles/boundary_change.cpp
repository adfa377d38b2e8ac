#include "particles/boundary_change.hpp"

namespace sabo {

void BoundaryChange::apply_to(Particles& boundary) const {
  if (!dropped.empty()) {
    const IdRuns runs{dropped.data(), dropped.size()};
    std::vector<std::uint32_t> kept;
    for (std::uint32_t k = 0; k < boundary.size(); ++k)
      if (!runs.hold(boundary.id[k])) kept.push_back(k);
    boundary.permute(kept);
  }
  boundary.append(made);
}

}  // namespace sabo
