#pragma once

#include <span>
#include <string_view>

#include "run/run_folder.hpp"
#include "run/scene.hpp"
#include "terrain/raster.hpp"

namespace sabo {

/// The maps of a run, in the solver frame.
struct RunMaps {
  Raster deposit;           ///< m
  Raster peak_depth;        ///< m
  Raster peak_speed;        ///< m/s
  Raster peak_pressure;     ///< Pa
  Raster peak_momentum;     ///< N/m
  Raster arrival;           ///< s
  Raster layers;            ///< greatest depth, particles
  double wet_depth = 0.05;  ///< above which a cell counted as wet, m
};

/// One of the maps that every run writes: its file, and how it is named wherever it is listed or
/// drawn.
struct MapKind {
  /// Values up to which a picture leaves a cell bare.
  enum class Bare { up_to_wet_depth, up_to_little, without_data };

  const char* name;         ///< of its file, maps/NAME.tif
  const char* title;        ///< of its picture
  const char* quantity;     ///< for legends, without its unit
  const char* unit;         ///< of its values in the file
  const char* description;  ///< what the values are
  bool is_of_wet_cells;     ///< they are only looked at where the flow is deeper than the wet depth
  Bare bare;
  const char* picture;  ///< of a run's page, without .svg; none if nullptr
  /// Values in `unit`; `ground` is the elevation, m.
  Raster (*values)(const RunMaps& maps, const Raster& ground);

  /// As pictures and outlines take it, in `unit`.
  double threshold(double wet_depth) const;
};

/// In the order in which they are listed.
std::span<const MapKind> map_kinds();

/// nullptr for a map that is not a result, as that of the ground.
const MapKind* map_kind(std::string_view name);

/// Writes the maps as GeoTIFF; that of the ground is there from the start, see scene_record.
void write_maps(const RunMaps& maps, const Case& c, const Scene& scene, const RunFolder& folder);

}  // namespace sabo
