#include "verify/drawn_gate.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace sabo {

DrawnGate::DrawnGate(Backend& backend, const Box& closed, std::uint16_t body, double acceleration)
    : backend_(backend),
      floor_(closed.low.z),
      body_(body),
      acceleration_(acceleration),
      lowest_(floor_) {
  add_box(backend.boundary(), backend.model(), closed, body);
}

void DrawnGate::rise_to(double time) {
  const double edge = floor_ + acceleration_ * time * time / 2;
  if (edge < lowest_) return;
  lowest_ = std::numeric_limits<double>::infinity();
  Particles& walls = backend_.boundary();
  std::vector<std::uint32_t> kept;
  kept.reserve(walls.size());
  for (std::uint32_t i = 0; i < walls.size(); ++i) {
    const double height = walls.position[i].z;
    const bool is_gate = walls.body[i] == body_;
    if (is_gate && height <= edge) continue;
    if (is_gate) lowest_ = std::min(lowest_, height);
    kept.push_back(i);
  }
  if (kept.size() == walls.size()) return;
  walls.permute(kept);
  backend_.find_neighbours();
}

}  // namespace sabo
