#include <array>
#include <cmath>

#include <fmt/format.h>

#include "io/case_file/templates.hpp"
#include "math/angle.hpp"

namespace sabo {
namespace {

constexpr const char* dam_break =
    R"toml(# Water that breaks out of one end of a tank against a box, laid out as the experiment of Kleefsman
# et al. (2005, J. Comput. Phys. 206, 363), with sizes rounded to the spacing. Units are SI, angles
# in degrees. Every other key and its default: sabo check --defaults
title = "Dam break in a tank"

[terrain.plane]  # the floor of the laboratory, in place of a DEM
extent = [-0.5, -0.5, 3.7, 1.5]  # west, south, east, north, m
elevation = 0  # m
slope = 0

[[body]]
name = "tank"
kind = "tank"  # its inside is free, floor and walls around it are solid; open at the top
min = [0, 0, 0]
max = [3.2, 1, 1]

[[body]]
name = "box"
kind = "box"
min = [2.4, 0.3, 0]
max = [2.55, 0.7, 0.15]
# rotation = 30  # degrees about its vertical axis

# A solid of any shape: remove the leading # and give an STL or OBJ file.
#[[body]]
#name = "building"
#kind = "mesh"
#file = "building.stl"
#frame = "local"  # its coordinates count from at; "crs": they are those of the terrain
#at = [1.5, 0.5, 0]

[release]
box = [0, 0, 0, 1.2, 1, 0.55]  # x0, y0, z0, x1, y1, z1: filled with water at rest

[material]
density = 1000
rheology = "newtonian"
viscosity = 0.001  # Pa s

# Discharge through the middle of the tank, positive along x.
[[section]]
name = "middle"
line = [[2, 0], [2, 1]]

# Mean depth behind the box.
[[zone]]
name = "behind the box"
polygon = [[2.6, 0.3], [3.1, 0.3], [3.1, 0.7], [2.6, 0.7]]

[numerics]
spacing = 0.05  # m; 0.025 shows the splash and takes about sixteen times as long
artificial_viscosity = 0.02  # water needs a little
wall = "slip"  # its boundary layer is thinner than a particle

[run]
duration = 3  # s
output_interval = 0.1
series_interval = 0.02
)toml";

constexpr const char* flume =
    R"toml(# A viscoplastic gel let go in an inclined flume, as in the laboratory. Units are SI, angles in
# degrees. Every other key and its default: sabo check --defaults
title = "Gel in a flume"

[terrain.plane]  # the bed, in place of a DEM
extent = [0, -0.5, 4, 0.5]  # west, south, east, north, m
elevation = 0  # m, of its lowest corner
slope = {slope}  # degrees
direction = 90  # to which it falls, clockwise from north: along x

[[body]]
name = "walls"
kind = "mesh"
file = "walls.obj"  # both sides and the upper end, {height} m high above the bed

[release]
# x0, y0, z0, x1, y1, z1: what of this box is above the bed, with a level surface.
box = [{start}, -{half_width}, 0, {gate}, {half_width}, {surface:.3f}]

[material]
preset = "carbopol_030"  # a gel of a laboratory; others: sabo models

# Discharge 1 m below the gate, positive down the flume.
[[section]]
name = "gauge"
line = [[2, -{half_width}], [2, {half_width}]]

[numerics]
spacing = 0.02  # m

[run]
duration = 4  # s
output_interval = 0.1
series_interval = 0.02
)toml";

/// The flume of its template, m.
struct Flume {
  double slope = 12;  // degrees
  double length = 4;  // of the bed
  double start = 0.4, gate = 1;
  double half_width = 0.15;
  double thickness = 0.1;  // of the walls
  double height = 0.25;
  double depth = 0.1;  // of the walls in the bed

  double bed(double x) const { return (length - x) * std::tan(slope * degree); }
};

}  // namespace

std::string dam_break_text() { return dam_break; }

std::string flume_text() {
  const Flume f;
  return fmt::format(fmt::runtime(flume), fmt::arg("slope", f.slope), fmt::arg("height", f.height),
                     fmt::arg("start", f.start), fmt::arg("gate", f.gate),
                     fmt::arg("half_width", f.half_width),
                     fmt::arg("surface", f.bed(f.gate) + 0.2));
}

std::string flume_walls_text() {
  const Flume f;
  const double inner = f.half_width, outer = f.half_width + f.thickness;
  const double back = f.start - f.thickness, end = f.length - 0.2;
  const double plan[8][2] = {{back, -outer},   {end, -outer}, {end, -inner}, {f.start, -inner},
                             {f.start, inner}, {end, inner},  {end, outer},  {back, outer}};
  std::string text = "# Two side walls and the upper end of a flume, m; z is up.\n";
  for (const double rise : {-f.depth, f.height})
    for (const auto& [x, y] : plan)
      text += fmt::format("v {:.4f} {:.4f} {:.4f}\n", x, y, f.bed(x) + rise);
  for (const auto& [a, b, c, d] : {std::array{1, 2, 3, 4}, {1, 4, 5, 8}, {8, 5, 6, 7}})
    text += fmt::format("f {} {} {} {}\nf {} {} {} {}\n", d, c, b, a, a + 8, b + 8, c + 8, d + 8);
  for (int k = 1; k <= 8; ++k) {
    const int next = k % 8 + 1;
    text += fmt::format("f {} {} {} {}\n", k, next, next + 8, k + 8);
  }
  return text;
}

}  // namespace sabo
