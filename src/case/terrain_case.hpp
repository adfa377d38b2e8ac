#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/describe.hpp"
#include "case/line_source.hpp"

namespace sabo {

enum class TerrainEditKind { set, lower, raise, smooth };
template <>
struct Words<TerrainEditKind> {
  static constexpr std::array<std::string_view, 4> list{"set", "lower", "raise", "smooth"};
};

/// A change of the DEM inside a polygon, before anything stands or flows on it.
struct TerrainEditCase {
  std::string name;
  LineSource polygon;
  TerrainEditKind kind = TerrainEditKind::set;
  std::optional<double> elevation;
  std::optional<double> by;
  std::optional<double> radius;

  template <class V>
  void describe(V&& v) {
    v(Key{"name", "", "used in the outputs"}, name);
    v(Key{"polygon", "", "where the DEM is changed: a vector file or coordinates"}.required(),
      polygon);
    v(Key{"kind", "",
          "set: to an elevation; lower, raise: by a height; smooth: to the mean within a radius; "
          "cells without data stay so"}
          .required(),
      kind);
    v(Key{"elevation", "m", "that `set` gives the ground"}.at_least(-1e4).at_most(1e4), elevation);
    v(Key{"by", "m", "height of `lower` and `raise`"}.above(0).at_most(1e4), by);
    v(Key{"radius", "m", "of the mean that `smooth` takes"}.above(0).at_most(1e4), radius);
  }
};

/// A terrain that is one level or tilted plane.
struct PlaneCase {
  std::array<double, 4> extent{};
  double elevation = 0;
  double slope = 0;
  double direction = 90;
  std::optional<double> cell_size;

  template <class V>
  void describe(V&& v) {
    v(Key{"extent", "m", "[west, south, east, north]"}.at_least(-1e8).at_most(1e8).required(),
      extent);
    v(Key{"elevation", "m", "of its lowest corner"}.at_least(-1e4).at_most(1e4), elevation);
    v(Key{"slope", "deg", "to the horizontal"}.at_least(0).at_most(60), slope);
    v(Key{"direction", "deg", "to which it falls, clockwise from north; 90 is along x"}
          .at_least(-360)
          .at_most(360),
      direction);
    v(Key{"cell_size", "m",
          "of the maps; default: two spacings, or more where these were over 4 million cells"}
          .at_least(1e-4)
          .at_most(1e4),
      cell_size);
  }
};

struct TerrainCase {
  std::filesystem::path dem;
  std::optional<PlaneCase> plane;
  bool assume_metres = false;
  std::string crs;
  std::optional<double> cell_size;
  std::optional<std::array<double, 4>> crop;
  double fill_holes = 25;
  std::vector<TerrainEditCase> edits;

  template <class V>
  void describe(V&& v) {
    v(Key{"dem", "",
          "elevation raster in any format of GDAL; or a GSI base map DEM (FG-GML): an .xml file, a "
          "folder or a .zip of them"},
      dem);
    v(Key{"plane", "", "in place of a DEM: a level or tilted plane, in metres without a CRS"},
      plane);
    v(Key{"assume_metres", "", "take a raster without a CRS as metres"}, assume_metres);
    v(Key{"crs", "",
          "projected CRS in metres that the DEM is brought to, e.g. EPSG:6670; default: its own, "
          "for FG-GML the UTM zone; a raster without a CRS is taken to be in it"},
      crs);
    v(Key{"cell_size", "m", "resample the DEM to square cells of this size"}.at_least(0.01).at_most(
          1e4),
      cell_size);
    v(Key{"crop", "m", "keep this window only: [west, south, east, north] in CRS coordinates"}
          .at_least(-1e8)
          .at_most(1e8),
      crop);
    v(Key{"fill_holes", "cells",
          "enclosed areas without data up to this size are filled from their rim; larger ones "
          "are outside the domain"}
          .at_least(0)
          .at_most(1e9),
      fill_holes);
    v.tables("edit", "changes of the DEM, made in the order of the file", edits);
  }
};

}  // namespace sabo
