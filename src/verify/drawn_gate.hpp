#pragma once

#include <cstdint>

#include "backend/backend.hpp"
#include "solver/lattice.hpp"

namespace sabo {

/// A gate before water that is drawn up from the floor at a constant speed: a wall of which row
/// after row is gone. Experiments that let water break out rarely say how their gate moved.
class DrawnGate {
 public:
  /// Puts the gate into the boundary as a body of its own, before any step; the speed in m/s.
  DrawnGate(Backend& backend, const Box& closed, std::uint16_t body, double speed);

  /// Between two steps: takes away what is above water at a time (s), 0 when it begins to rise.
  void rise_to(double time);

 private:
  Backend& backend_;
  double floor_;
  std::uint16_t body_;
  double speed_;
  double lowest_;  // what is left of it begins there or above, m
};

/// The slowest speed at which a gate counts as drawn at once: out of water of a depth (m) within
/// sqrt(2 H / g) (Lauber & Hager, J. Hydraul. Res. 36 (1998) 291), m/s.
double slowest_sudden_gate(double depth, double gravity);

}  // namespace sabo
