#pragma once

#include <functional>

#include "backend/backend.hpp"
#include "base/background.hpp"

namespace sabo {

/// Lets work see the fluid as it is: at once where that is in the memory of the host, else beside
/// the steps, at a copy.
inline void show_fluid(Backend& backend, Background& beside,
                       const std::function<void(const Particles&)>& work) {
  if (backend.device_bytes() == 0) return work(backend.fluid());
  beside.start([work, fluid = backend.keep_fluid()] { work(fluid.get()); });
}

}  // namespace sabo
