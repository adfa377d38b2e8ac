#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "math/vec3.hpp"
#include "terrain/surface.hpp"

namespace sabo {

struct GroundSettings {
  double spacing = 1;     ///< particle spacing, m
  int layers = 3;         ///< layers below the surface; their depth must reach the kernel radius
  double density = 1000;  ///< reference density of new particles, kg/m3
};

/// A boundary particle to be.
struct GroundPoint {
  Vec3d position;
  double mass = 0;         ///< kg
  std::uint16_t body = 0;  ///< see Particles
};

/// Columns of particles below the ground, on the horizontal lattice of the whole map.
///
/// Layer k lies (k + 1/2) spacings below the surface, measured along the normal. The columns are
/// shifted vertically by spacing / cos(slope): on a plane that is the same set of parallel layers,
/// and on curved ground columns never cross or part, which layers moved along the normals do. Where
/// the slope would stretch the lattice beyond about 1.25 spacings along the ground, a column is
/// split. A particle's mass is density x (area of its column in plan) x (vertical distance of
/// layers), so that the layers fill the ground exactly.
///
/// Broken ground (cliffs, sharp edges, steps, one-cell noise) has no tangent plane that holds for
/// the depth of the layers. There layer k is the surface moved (k + 1/2) spacings inwards, see
/// inset_height(), cut into pieces of about one squared spacing along itself, a particle in the
/// middle of each; its mass is density x spacing x area of its piece.
class GroundColumns {
 public:
  GroundColumns(const Surface& surface, const GroundSettings& settings);

  /// Appends the particles of the column with centre ((i + 1/2) spacing, (j + 1/2) spacing); none
  /// outside the domain, except up to (layers + 1) spacings from it if `beyond_edge`: there the
  /// ground goes on straight, so that the wall has full support at its edges.
  void make(std::int64_t i, std::int64_t j, bool beyond_edge, std::vector<GroundPoint>& into) const;

  /// Distance from the domain at which the last columns can stand, m.
  double margin() const { return (settings_.layers + 1) * settings_.spacing; }

 private:
  struct Foot;
  /// Centre and sides of a rectangle in plan, m.
  struct Piece {
    double x, y, width, length;
  };
  Foot foot_at(double x, double y) const;
  bool find_foot(std::int64_t i, std::int64_t j, bool beyond_edge, Foot& foot) const;
  double slope(double x, double y, double dx, double dy) const;
  bool is_broken(const Foot& foot) const;
  double layer_height(double x, double y, int layer) const;
  void fill(const Piece& piece, int layer, int halvings, std::vector<GroundPoint>& into) const;

  double centre(std::int64_t k) const { return (k + 0.5) * settings_.spacing; }

  const Surface& surface_;
  GroundSettings settings_;
  std::vector<std::array<int, 2>> offsets_;  // lattice steps within the margin, shortest first
};

}  // namespace sabo
