#include "terrain/body.hpp"

#include <limits>
#include <utility>

namespace sabo {

Body::Body(std::string name, TriangleMesh mesh, FlowSide flow, double reach,
           std::vector<UprightBox> boxes)
    : name_(std::move(name)),
      distance_(std::make_shared<MeshDistance>(std::move(mesh))),
      inside_(std::make_shared<InsideMap>(distance_, reach / 3)),
      flow_(flow),
      reach_(reach),
      boxes_(std::move(boxes)) {}

Bounds Body::bounds() const {
  return flow_ == FlowSide::outside ? distance_->bounds() : distance_->bounds().widened(reach_);
}

bool Body::is_behind(const Vec3d& point) const {
  return inside_->is_inside(point) == (flow_ == FlowSide::outside);
}

bool Body::contains(const Vec3d& point) const {
  if (!bounds().contains(point) || !is_behind(point)) return false;
  return flow_ == FlowSide::outside || distance_->nearest(point, reach_).has_value();
}

std::optional<Vec3d> Body::way_out(const Vec3d& point, double gap,
                                   const std::function<bool(const Vec3d&)>& accepts) const {
  const double to_flow = flow_ == FlowSide::outside ? 1 : -1;
  const auto normal_of = [&](std::uint32_t triangle) {
    const Vec3d area = area_vector(mesh(), triangle);
    return norm(area) > 0 ? to_flow / norm(area) * area : Vec3d{0, 0, 1};
  };
  const auto beyond = [&](const MeshPoint& found) {
    const Vec3d way = found.point - point;
    // From the surface itself its normal leads out.
    const Vec3d out = found.distance > gap ? (1 / found.distance) * way : normal_of(found.triangle);
    return found.point + gap * out;
  };
  const auto found =
      distance_->nearest(point, std::numeric_limits<double>::max(),
                         [&](const MeshPoint& place) { return accepts(beyond(place)); });
  if (!found) return {};
  // From the outer half of a shell the way through its back is shorter.
  if (flow_ == FlowSide::inside && found->distance > reach_ / 2) {
    const Vec3d back = found->point + (reach_ + gap) / found->distance * (point - found->point);
    if (accepts(back)) return back;
  }
  return beyond(*found);
}

}  // namespace sabo
