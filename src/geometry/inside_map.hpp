#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "geometry/mesh_distance.hpp"

namespace sabo {

/// Tells fast whether a point is inside a mesh: the box around it is cut into cells, and only those
/// that the surface passes through ask the mesh itself.
class InsideMap {
 public:
  /// Cells of at least `cell` (m), larger where more than a few million would be needed.
  InsideMap(std::shared_ptr<const MeshDistance> mesh, double cell);

  bool is_inside(const Vec3d& point) const;

 private:
  enum class Side : char { both, outside, inside };
  struct Block {
    int first[3];
    int last[3];  // one beyond
  };
  void fill(const Block& block);
  void set(const Block& block, Side side);
  std::size_t index(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * count_[1] + j) * count_[0] + i;
  }

  std::shared_ptr<const MeshDistance> mesh_;
  double cell_;
  int count_[3];
  std::vector<Side> sides_;
};

}  // namespace sabo
