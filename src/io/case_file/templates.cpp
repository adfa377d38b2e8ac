#include "io/case_file/templates.hpp"

#include <fmt/format.h>

namespace sabo {
namespace {

constexpr const char* yohutagawa =
    R"toml(# The debris flow of 2010 at Yohutagawa, Amami Oshima, Japan. SI units, angles in degrees.
# Every other key and its default: sabo check --defaults
title = "Yohutagawa 2010 (generated terrain)"
note = "Terrain generated from published numbers: a consistency check, not a validation"

[terrain]
# Generated. With the DEM of the site (e.g. the .zip of 5 m tiles that the Geospatial Information
# Authority of Japan gives out), change this and the other files.
dem = "dem.tif"

[release]
thickness_raster = "release.tif"
volume = {volume}  # m3; the raster is scaled to it

[material]
density = 1726  # kg/m3: 44 % solids of 2650 kg/m3 in water
rheology = "cross"
viscosity = 1255  # Pa s
viscosity_ratio = 1000  # as published; creep below yield falls with it
cohesion = 0  # Pa
friction_angle = 28
# r_u, the share of the normal stress carried by pore water. The published run has none: its
# friction alone stops a flow whose path falls less than 0.53 m per m. Hydrostatic pore water in
# this mixture would be 0.58.
pore_pressure_ratio = 0

[[structure]]
name = "dam"
kind = "check_dam"
line = "dam.gpkg"
height = {dam_height}  # m, of the crest above the lowest ground along the line
thickness = {dam_thickness}  # m, along the flow

[structure.notch]
centre = {notch_centre}  # m along the line
width = {notch_width}  # m
depth = {notch_depth}  # m below the crest

[[section]]
name = "p1"  # above the dam
line = {above_dam}

[[section]]
name = "p2"  # below the dam
line = {below_dam}

{zones}[path]
line = "path.gpkg"

# Volumes to compare with, m3.
[[reference]]
name = "published simulation"
released = 8863
trapped = 5353
beyond = 3510

[[reference]]
name = "field survey"
released = 8697
trapped = 5621
beyond = 3076

[numerics]
spacing = 0.75  # m, as published; 1.5 is many times faster
method = "paper"
reference_speed = 20  # m/s, near the fastest expected; it bounds the speed of sound from below

[run]
duration = 300  # s
output_interval = 5  # s between frames
)toml";

constexpr const char* valley_from_dem =
    R"toml(# A debris flow in your own valley. Put dem.tif and release.gpkg beside this file, edit it, then
#    sabo check .   and   sabo run .
# Units are SI, angles in degrees. Every other key and its default: sabo check --defaults
title = "My valley"

[terrain]
# Elevation, in any raster format of GDAL, or tiles of the Japanese base map (FG-GML: an .xml file, a
# folder or a .zip). A DEM in degrees needs crs = "EPSG:..." to be brought to metres. Cells of 1 to 5 m
# show a channel well.
dem = "dem.tif"

[release]
# What starts to move: a polygon in any vector format, and its volume in m3 (or thickness = m). Or
# the surfaces before and after an event: dem_before = "...", dem_after = "...".
polygon = "release.gpkg"
volume = 5000

[material]
# Documented materials to start from: preset = "...", listed by sabo models.
# Mixture of stones, soil and water: 1500 to 2000 kg/m3.
density = 1800
# "cross" behaves as a Bingham fluid and needs no cap; other laws: sabo models
rheology = "cross"
# Plastic viscosity: 8 and 34 Pa s were measured in fine mud (presets); for a whole flow calibrate it.
viscosity = 500
# Strength: cohesion in Pa (0 to 1000) and internal friction in degrees (25 to 35).
cohesion = 0
friction_angle = 30
# Share of the weight carried by pore water. It decides how far the flow goes: 0 is dry, about 0.5
# to 0.6 is saturated at rest, up to 0.9 is partly liquefied.
pore_pressure_ratio = 0.5

# A check dam: remove the leading # and give its line, as a file or as coordinates of the DEM's CRS.
#[[structure]]
#name = "dam"
#line = [[500100, 4100200], [500140, 4100210]]
#height = 8       # m above the lowest ground along the line, or crest = elevation
#thickness = 3    # m along the flow

# A change of the DEM, here a basin 2 m deep; other kinds: set, raise, smooth.
#[[terrain.edit]]
#name = "basin"
#kind = "lower"
#by = 2  # m
#polygon = [[500080, 4100190], [500100, 4100190], [500100, 4100210], [500080, 4100210]]

# A line across the channel through which discharge is measured.
#[[section]]
#name = "bridge"
#line = [[500300, 4100180], [500330, 4100190]]

# An area in which the depth is measured, with an observed mean depth if there is one.
#[[zone]]
#name = "field"
#polygon = [[500400, 4100180], [500450, 4100180], [500450, 4100220], [500400, 4100220]]
#observed = 0.8  # m
#source = "survey"

[numerics]
# Distance of particles in m: the flow should be at least four of them deep. Start coarse; half the
# spacing takes sixteen times as long or more.
spacing = 1.0

[run]
duration = 120  # s
output_interval = 5  # s between frames
)toml";

template <std::size_t count>
std::string points_text(const std::array<std::array<double, 2>, count>& points) {
  std::string text;
  for (const auto& [x, y] : points)
    text += fmt::format("{}[{}, {}]", text.empty() ? "" : ", ", x, y);
  return "[" + text + "]";
}

/// The zones of the deposit; the text gives a depth for the fan alone.
std::string zones_text(const YohutagawaNumbers& n) {
  std::string text;
  for (const YohutagawaNumbers::Zone& zone : n.zones) {
    text += fmt::format("[[zone]]\nname = \"{}\"\npolygon = {}\n", zone.name,
                        points_text(zone.corners));
    if (&zone == &n.zones[2]) text += "observed = 0.3\nsource = \"published simulation\"\n";
    text += "\n";
  }
  return text;
}

}  // namespace

std::string yohutagawa_text(const YohutagawaNumbers& n) {
  return fmt::format(
      fmt::runtime(yohutagawa), fmt::arg("volume", n.volume), fmt::arg("dam_height", n.dam_height),
      fmt::arg("dam_thickness", n.dam_thickness), fmt::arg("notch_centre", n.notch_centre),
      fmt::arg("notch_width", n.notch_width), fmt::arg("notch_depth", n.notch_depth),
      fmt::arg("above_dam", points_text(n.above_dam)),
      fmt::arg("below_dam", points_text(n.below_dam)), fmt::arg("zones", zones_text(n)));
}

std::string valley_from_dem_text() { return valley_from_dem; }

}  // namespace sabo
