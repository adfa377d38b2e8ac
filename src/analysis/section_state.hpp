#pragma once

#include <vector>

#include "particles/particles.hpp"
#include "terrain/polyline.hpp"
#include "terrain/surface.hpp"

namespace sabo {

/// What flows through a section at one moment, from the particles in a slab about it.
struct SectionState {
  double area = 0;            ///< of the flow across the section, m2
  double depth = 0;           ///< greatest, over a width of about two spacings, m
  double mean_speed = 0;      ///< through the section, by volume; left to right is positive, m/s
  double greatest_speed = 0;  ///< of a particle through the section, either way, m/s

  /// The flow by its height above the ground.
  struct Layer {
    double height = 0;  ///< middle of the layer, m
    double area = 0;    ///< m2
    double speed = 0;   ///< mean through the section, m/s
  };
  std::vector<Layer> layers;  ///< as thick as a spacing, from the ground up
};

/// Sections are measured over a slab of two spacings (m) to each side; volumes are masses over the
/// reference density (kg/m3).
class SectionSlab {
 public:
  SectionSlab(Polyline line, double spacing, double reference_density);

  SectionState measure(const Surface& ground, const Particles& particles) const;

 private:
  Polyline line_;
  double length_, spacing_, density_;
};

}  // namespace sabo
