#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "math/vec3.hpp"

namespace sabo {

// What Particles::body holds: the number of the body that a boundary particle is a part of, with a
// mark if it is the ground under it, see Ground.
inline constexpr std::uint16_t foundation_mark = 0x8000;
inline constexpr std::uint16_t most_bodies = foundation_mark - 1;

// The one list of particle fields: X(type, name, unit, meaning, is_shown). Members, sizes,
// permutations and the arrays of a frame come from it; a frame leaves out what is not shown.
#define SABO_PARTICLE_FIELDS(X)                                                                    \
  X(Vec3d, position, "m", "position in the solver frame, z up", true)                              \
  X(Vec3d, velocity, "m/s", "velocity", true)                                                      \
  X(double, density, "kg/m3", "density", true)                                                     \
  X(double, mass, "kg", "mass; constant in time", true)                                            \
  X(std::uint32_t, id, "", "number that stays with the particle for the whole run", true)          \
  X(double, pressure, "Pa", "pressure of the last evaluation; may be negative", true)              \
  X(double, viscosity, "Pa s", "effective viscosity of the last evaluation", true)                 \
  X(double, shear_rate, "1/s", "engineering shear rate of the last evaluation", true)              \
  X(std::uint16_t, body, "", "body that bears what acts on it; 0: none", false)                    \
  X(std::uint16_t, driven, "", "number of the inflow that moves it, from 1; 0: it is free", false) \
  X(double, calm, "s", "time since it last moved; 0 unless deposits may sleep", false)             \
  X(Vec3d, drag, "m/s2", "acceleration by an implicit viscosity, guess of the next", false)

/// Structure of arrays, all of equal length.
struct Particles {
#define SABO_DECLARE_FIELD(type, name, unit, meaning, is_shown) std::vector<type> name;
  SABO_PARTICLE_FIELDS(SABO_DECLARE_FIELD)
#undef SABO_DECLARE_FIELD

  std::size_t size() const { return position.size(); }

  /// New entries are zero.
  void resize(std::size_t count);

  /// Row k of the result is row order[k] of this set; `order` may leave rows out.
  void permute(const std::vector<std::uint32_t>& order);

  /// Row rows[k] becomes row k of another set, which has as many.
  void put(const Particles& source, const std::vector<std::uint32_t>& rows);

  /// Appends the given rows of another set.
  void append(const Particles& source, const std::vector<std::uint32_t>& rows);
  /// Appends all of another set.
  void append(const Particles& source);

  /// Throws RunError when the arrays that are read differ in length.
  template <class Archive>
  void archive(Archive& a) {
#define SABO_ARCHIVE_FIELD(type, name, unit, meaning, is_shown) a(name);
    SABO_PARTICLE_FIELDS(SABO_ARCHIVE_FIELD)
#undef SABO_ARCHIVE_FIELD
    if constexpr (Archive::is_reader) check_lengths();
  }

  /// Calls f(name, unit, meaning, array) for each field that is shown.
  template <class F>
  void for_each_shown_field(F&& f) const {
#define SABO_VISIT_FIELD(type, name, unit, meaning, is_shown) \
  if constexpr (is_shown) f(#name, unit, meaning, name);
    SABO_PARTICLE_FIELDS(SABO_VISIT_FIELD)
#undef SABO_VISIT_FIELD
  }

 private:
  void check_lengths() const;
};

}  // namespace sabo
