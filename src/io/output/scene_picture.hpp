#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/output/camera.hpp"
#include "io/output/map_picture.hpp"
#include "io/output/scene_bodies.hpp"
#include "terrain/raster.hpp"

namespace sabo {

/// A valley with a flow in perspective. All coordinates are in one frame.
struct ScenePicture {
  std::string title = {};
  std::string note = {};           ///< small, under the title; "" for none
  std::string quantity = {};       ///< of the values, with its unit, e.g. "speed [m/s]"
  double threshold = 0;            ///< depth that counts as flow, m
  std::optional<double> top = {};  ///< value of the darkest colour, else from the data
  MapView view = {};               ///< the ground to draw
  std::optional<double> azimuth =
      {};                           ///< of LookDirection, else up the valley where the flow shows
  std::optional<double> down = {};  ///< of LookDirection, else 35 degrees or steeper
  double exaggeration = 1;          ///< of heights; stated on the picture when it is not 1
  std::vector<SceneBody> bodies = {};
  std::vector<MapLine> lines = {};  ///< laid on the surface; a path also tells which way is up
};

/// The direction of the picture's camera, as given or as chosen; pictures of one series should have
/// one direction, that of the greatest depths for instance.
LookDirection scene_direction(const ScenePicture& scene, const Raster& elevation,
                              const Raster& depth);

/// The picture as an SVG file: the ground as a grey relief, lifted by the depth (m) and coloured by
/// the values where there is flow. The camera holds the whole flow and the
/// bodies over the view. The rasters have one grid, NaN where there is no data. Throws RunError.
std::string scene_svg(const ScenePicture& scene, const Raster& elevation, const Raster& depth,
                      const Raster& values);

}  // namespace sabo
