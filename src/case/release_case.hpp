#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>

#include "base/describe.hpp"
#include "case/line_source.hpp"

namespace sabo {

struct ReleaseCase {
  LineSource polygon;
  std::filesystem::path thickness_raster;
  std::filesystem::path points;
  std::array<double, 3> points_offset{0, 0, 0};
  double point_volume = 1;
  std::optional<std::array<double, 6>> box;
  std::filesystem::path dem_before;
  std::filesystem::path dem_after;
  double least_thickness = 0;
  std::optional<double> thickness;
  std::string thickness_attribute;
  std::optional<double> volume;
  bool normal = false;
  double jitter = 0;
  int seed = 0;

  /// Whether anything starts to move at once.
  bool given() const {
    return polygon.given() || !thickness_raster.empty() || !points.empty() || box ||
           !dem_before.empty();
  }

  template <class V>
  void describe(V&& v) {
    v(Key{"polygon", "",
          "release area: a vector file or coordinates; needs thickness, thickness_attribute or "
          "volume. With dem_before and dem_after: where they are compared"},
      polygon);
    v(Key{"thickness_raster", "m", "raster of release thickness in the CRS of the DEM"},
      thickness_raster);
    v(Key{"points", "", "text file of points x y z, each the centre of point_volume"}, points);
    v(Key{"points_offset", "m", "added to the points"}.at_least(-1e8).at_most(1e8), points_offset);
    v(Key{"point_volume", "m3", "volume each point stands for"}.above(0).at_most(1e9),
      point_volume);
    v(Key{"box", "m",
          "[x0, y0, z0, x1, y1, z1]: all of this box that is above the ground and outside of "
          "bodies, with a level surface"}
          .at_least(-1e8)
          .at_most(1e8),
      box);
    v(Key{"dem_before", "m",
          "surface before the event; what lies between it and dem_after is released, and the "
          "ground there is lowered to dem_after; both in the CRS of the DEM"},
      dem_before);
    v(Key{"dem_after", "m", "surface after the event"}, dem_after);
    v(Key{"least_thickness", "m", "smaller differences of dem_before and dem_after are noise"}
          .at_least(0)
          .at_most(1e4),
      least_thickness);
    v(Key{"thickness", "m", "release thickness of the polygon"}.above(0).at_most(1e4), thickness);
    v(Key{"thickness_attribute", "",
          "attribute of the polygon file that holds the thickness of each polygon, m"},
      thickness_attribute);
    v(Key{"volume", "m3",
          "release volume: in place of a thickness of the polygon, or scales thickness_attribute, "
          "thickness_raster or what lies between dem_before and dem_after"}
          .above(0)
          .at_most(1e12),
      volume);
    v(Key{"normal", "", "thickness is normal to the ground, not vertical"}, normal);
    v(Key{"jitter", "",
          "random displacement of each released particle along x, y and z, at most this share of "
          "the spacing: for ensembles"}
          .at_least(0)
          .at_most(0.3),
      jitter);
    v(Key{"seed", "", "number of the random displacements; each gives others"}.at_least(0).at_most(
          1e9),
      seed);
  }
};

}  // namespace sabo
