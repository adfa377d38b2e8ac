#pragma once

#include <gtest/gtest.h>

#include "run/scene.hpp"

namespace sabo {

/// The scene of a case that has no faults.
inline Scene scene_of(const Case& c) {
  Faults faults;
  Scene scene = make_scene(c, faults);
  for (const Fault& fault : faults.list()) ADD_FAILURE() << to_string(fault);
  return scene;
}

}  // namespace sabo
