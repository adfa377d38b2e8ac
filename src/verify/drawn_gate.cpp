#include "verify/drawn_gate.hpp"

#include <cmath>
#include <vector>

namespace sabo {

DrawnGate::DrawnGate(Backend& backend, const Box& closed, std::uint16_t body, double speed)
    : backend_(backend), floor_(closed.low.z), body_(body), speed_(speed) {
  add_box(backend.boundary(), backend.model(), closed, body);
}

void DrawnGate::rise_to(double time) {
  const double edge = floor_ + speed_ * time;
  Particles& walls = backend_.boundary();
  std::vector<std::uint32_t> kept;
  kept.reserve(walls.size());
  for (std::uint32_t i = 0; i < walls.size(); ++i)
    if (walls.body[i] != body_ || walls.position[i].z > edge) kept.push_back(i);
  if (kept.size() == walls.size()) return;
  walls.permute(kept);
  backend_.find_neighbours();
}

double slowest_sudden_gate(double depth, double gravity) { return std::sqrt(gravity * depth / 2); }

}  // namespace sabo
