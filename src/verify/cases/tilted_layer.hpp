#pragma once

#include <memory>

#include "backend/backend.hpp"

namespace sabo {

/// A layer on the plane of a DEM that falls by 30 degrees along x, without ends: the period along
/// the slope leans as the plane does. In three dimensions, under vertical gravity.
struct TiltedLayer {
  FlowModel model;
  int cells = 10;  ///< thickness of the layer, normal to the plane

  static constexpr double slope = 0.52359877559829887;  ///< rad
  // 13 columns of ground in plan are 15.01 spacings along the slope.
  static constexpr int columns = 13, rows = 15, width = 8;

  /// At rest, with the pressure of its weight.
  std::unique_ptr<Backend> make() const;

  static double along(const Vec3d& v);   ///< down the slope
  static double height(const Vec3d& x);  ///< above the plane, normal to it, m
};

}  // namespace sabo
