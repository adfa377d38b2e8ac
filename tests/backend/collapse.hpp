#pragma once

#include <cmath>

#include "support/clouds.hpp"
#include "support/scenes.hpp"

#include "backend/backend.hpp"

namespace sabo::test {

inline FlowModel collapsing() {
  FlowModel model = plain_model(0.1, 30, 5);
  model.rheology = Cross{5, 100, 1};
  model.yield = {20, 20, 0};
  return model;
}

/// A block on a floor that is wider.
inline void fill(Backend& backend) {
  add_block(backend.fluid(), backend.model(), {0, 6, 0, 6, 0, 6});
  add_block(backend.boundary(), backend.model(), {-6, 12, -6, 12, -3, 0});
  for (std::size_t i = 0; i < backend.fluid().size(); ++i)
    backend.fluid().density[i] *= 1 + 0.001 * std::sin(double(i));
}

}  // namespace sabo::test
