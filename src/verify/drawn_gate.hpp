#pragma once

#include <cstdint>

#include "backend/backend.hpp"
#include "solver/lattice.hpp"

namespace sabo {

/// A gate before water that a weight draws up from the floor: a wall of which row after row is
/// gone. Experiments that let water break out rarely say how their gate moved; one with the
/// acceleration of gravity, which no weight exceeds, is out of water of the depth H after
/// sqrt(2 H / g), the limit up to which Lauber & Hager (J. Hydraul. Res. 36 (1998) 291) call a
/// break sudden.
class DrawnGate {
 public:
  /// Puts the gate into the boundary as a body of its own, before any step; the acceleration in
  /// m/s2.
  DrawnGate(Backend& backend, const Box& closed, std::uint16_t body, double acceleration);

  /// Between two steps: takes away what is above water at a time (s), 0 when it begins to rise.
  void rise_to(double time);

 private:
  Backend& backend_;
  double floor_;
  std::uint16_t body_;
  double acceleration_;
  double lowest_;  // what is left of it begins there or above, m
};

}  // namespace sabo
