#pragma once

#include <string>
#include <variant>
#include <vector>

#include "terrain/polyline.hpp"
#include "terrain/raster.hpp"

namespace sabo {

struct SetElevation {
  double elevation = 0;  ///< m
};
struct ShiftElevation {
  double by = 0;  ///< m, upwards
};
struct SmoothElevation {
  double radius = 0;  ///< m, of the circle whose mean a cell takes
};

/// A change of the ground inside polygons.
struct TerrainEdit {
  std::string name;
  std::vector<Polygon> polygons;
  std::variant<SetElevation, ShiftElevation, SmoothElevation> change;
};

/// What an edit did.
struct EditReport {
  std::string name;
  std::size_t cells = 0;  ///< with data, inside the polygons
  double cut = 0;         ///< m3 taken away
  double fill = 0;        ///< m3 added
  double greatest = 0;    ///< change of elevation, m, not negative
};

/// Changes the cells with data whose centres lie in the polygons; cells without data stay so. The
/// mean of SmoothElevation is that of the cells with data, as they were before the edit, whose
/// centres lie within the radius.
EditReport apply(const TerrainEdit& edit, Raster& ground);

}  // namespace sabo
