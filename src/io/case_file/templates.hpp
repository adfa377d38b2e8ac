#pragma once

#include <array>
#include <string>
#include <string_view>

namespace sabo {

/// A case that `sabo new` can write.
struct Template {
  std::string_view name;
  std::string_view summary;
};

inline constexpr std::array<Template, 4> templates{{
    {"yohutagawa", "the debris flow of 2010 at Yohutagawa, Amami Oshima, on generated terrain"},
    {"valley-from-dem", "your own valley: a DEM, a release area and a check dam to edit"},
    {"dam-break", "water in a tank that breaks against a box"},
    {"flume", "a viscoplastic gel in an inclined flume, its walls from a mesh"},
}};

/// What the generated files of `yohutagawa` decide.
struct YohutagawaNumbers {
  using Section = std::array<std::array<double, 2>, 2>;  ///< two points (x, y), m
  double volume = 8863;                                  ///< m3
  double dam_height = 8;                                 ///< above the bed, m
  double dam_thickness = 3.2;                            ///< m
  double notch_centre = 0;                               ///< along the dam's line, m
  double notch_width = 10;                               ///< m
  double notch_depth = 1.5;                              ///< m
  Section above_dam{};                                   ///< p1
  Section below_dam{};                                   ///< p2

  struct Zone {
    std::string name;
    std::array<std::array<double, 2>, 4> corners{};
  };
  std::array<Zone, 4> zones{};  ///< down the valley; the third is the upper fan
};

/// Case file beside dem.tif, release.tif, dam.gpkg and path.gpkg.
std::string yohutagawa_text(const YohutagawaNumbers& numbers);

/// Case file to edit, for dem.tif and release.gpkg of the user.
std::string valley_from_dem_text();

/// Case file that needs no other.
std::string dam_break_text();

/// Case file beside walls.obj, and that file.
std::string flume_text();
std::string flume_walls_text();

}  // namespace sabo
