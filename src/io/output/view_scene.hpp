#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "geometry/triangle_mesh.hpp"

#include "io/output/map_line.hpp"
#include "terrain/raster.hpp"

namespace sabo {

/// Version of the files of the folder view/, which the page checks.
inline constexpr int view_format = 1;

/// A solid of the 3D view.
struct ViewSolid {
  std::string name = {};
  TriangleMesh mesh = {};  ///< solver frame
};

struct ViewFrameEntry {
  std::size_t number = 0;
  double time = 0;        ///< s
  std::size_t count = 0;  ///< of particles
};

/// All of the 3D view that does not change with time, in the solver frame.
struct ViewScene {
  std::string title = {};
  std::string note = {};
  std::string run = {};      ///< name of the run's folder, which tells two runs apart
  std::string program = {};  ///< what wrote it, "sabo 0.1.0"
  Frame frame = {};
  Raster ground = {};      ///< NaN without data
  int stride = 1;          ///< cells of the DEM for one of the ground
  double spacing = 1;      ///< of the particles, m
  std::size_t one_of = 1;  ///< of so many particles one is shown
  double depth_top = 0;    ///< of the colours: depth, m; speed, m/s; pressure, Pa
  double speed_top = 0;
  double pressure_top = 0;
  std::vector<ViewSolid> solids = {};
  std::vector<MapLine> lines = {};
  std::vector<ViewFrameEntry> frames = {};
};

/// A script that hands the scene to the page. Heights of the ground are whole numbers from 0 to
/// 65534 between the lowest and the highest, 65535 without data; solids are 32-bit floats, three
/// corners for each triangle.
std::string view_scene_script(const ViewScene& scene);

}  // namespace sabo
