#pragma once

#include <vector>

#include "backend/host_backend.hpp"

namespace sabo {

/// Calls f(j) for the fluid near a particle of a host backend, see HostBackend::fluid_near().
class HostNear {
 public:
  explicit HostNear(const HostBackend& backend) : backend_(&backend) {}

  template <class F>
  void operator()(std::size_t i, const F& f) const {
    thread_local std::vector<std::uint32_t> near;
    near.clear();
    backend_->fluid_near(i, near);
    for (const std::uint32_t j : near) f(std::size_t{j});
  }

 private:
  const HostBackend* backend_;
};

}  // namespace sabo
