#pragma once

#include <vector>

#include "geometry/triangle_mesh.hpp"

namespace sabo {

/// A box, turned about the vertical.
struct UprightBox {
  Vec3d low;        ///< corner before the turn
  Vec3d high;       ///< the corner across
  Vec3d pivot;      ///< the vertical through it is the axis of the turn
  double turn = 0;  ///< anticlockwise seen from above, rad

  Vec3d size() const { return high - low; }
  /// Where a point of the box that is not turned goes.
  Vec3d turned(const Vec3d& point) const;
};

/// Its surface, 12 triangles that face outwards.
TriangleMesh box_mesh(const UprightBox& box);

/// Boxes that fill the floor and walls, each `thickness` (m) thick, around an inside: floor first,
/// then four walls as high as the inside, then a lid if it is closed. They touch and do not
/// overlap.
std::vector<UprightBox> tank_boxes(const UprightBox& inside, double thickness, bool is_open);

/// The surface of floor, walls and lid as one solid, facing outwards.
TriangleMesh tank_mesh(const UprightBox& inside, double thickness, bool is_open);

}  // namespace sabo
