#pragma once

#include "particles/particles.hpp"

namespace sabo {

/// Where the fields of a set of particles are, in the memory of the host or of a device.
struct ParticleView {
#define SABO_DECLARE_POINTER(type, name, unit, meaning, is_shown) type* name = nullptr;
  SABO_PARTICLE_FIELDS(SABO_DECLARE_POINTER)
#undef SABO_DECLARE_POINTER
};

inline ParticleView view_of(Particles& particles) {
  ParticleView view;
#define SABO_POINT_TO_FIELD(type, name, unit, meaning, is_shown) view.name = particles.name.data();
  SABO_PARTICLE_FIELDS(SABO_POINT_TO_FIELD)
#undef SABO_POINT_TO_FIELD
  return view;
}

}  // namespace sabo
