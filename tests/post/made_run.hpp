#pragma once

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <sstream>
#include <string>

#include "support/temporary_folder.hpp"

#include "io/gis/crs.hpp"
#include "io/gis/raster_file.hpp"
#include "io/gis/write_raster.hpp"
#include "terrain/raster.hpp"

namespace sabo {

inline std::string file_text(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

/// A map in the folder of a result.
inline Raster map_of(const std::filesystem::path& folder, const std::string& name) {
  return RasterFile(folder / "maps" / (name + ".tif"), "map").read();
}

/// WKT of UTM zone 54 north.
inline std::string wkt_of_test_crs() {
  OGRSpatialReference crs;
  crs.importFromEPSG(32654);
  return wkt_of(crs);
}

/// The folder of a run as it is left, written by hand: 20 x 10 cells of 2 m, x from 0 to 40 and y
/// from 0 to 20, on a tilted plane, with a path and a zone.
struct MadeRun {
  std::string title = "made";
  Grid grid = {20, 10, 0, 20, 2, 2};
  std::string crs = {};
  /// Depth at the end, m, over x and y; the greatest one is twice that.
  std::function<double(double x, double y)> depth = [](double, double) { return 0.0; };
  double speed = 3;  ///< m/s, where there is depth
  std::string quantities = "\"front run-out [m]\" = 12\n\"peak discharge at s [m3/s]\" = 4\n";
  double simulated = 10;  ///< s
  std::string keys = {};  ///< appended to the case

  void write(const std::filesystem::path& folder) const {
    std::filesystem::create_directories(folder / "maps");
    std::filesystem::create_directories(folder / "series");
    put(folder / "manifest.toml", "[run]\nend = \"finished\"\nversion = \"test\"\nsimulated_s = " +
                                      std::to_string(simulated) +
                                      "\n\n[[volumes]]\nreleased = 100\n\n[[load]]\nname = "
                                      "\"dam\"\npeak_force = 5000\n\n[quantities]\n" +
                                      quantities);
    put(folder / "case.toml", case_text());
    put(folder / "series" / "front.csv",
        "time [s],position [m],displacement [m],velocity [m/s]\n0,1,0,0\n1,4,3,3\n");
    const auto map = [&](const char* name, const char* unit, const auto& value) {
      Raster raster(grid);
      for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column)
          raster.at(column, row) = value(grid.x_of(column), grid.y_of(row));
      write_raster(folder / "maps" / (std::string(name) + ".tif"), raster, {crs, name, unit});
    };
    map("dep", "m", depth);
    map("pfd", "m", [&](double x, double y) { return 2 * depth(x, y); });
    map("pfv", "m/s", [&](double x, double y) { return depth(x, y) > 0 ? speed : 0; });
    map("tarr", "s", [&](double x, double y) {
      return depth(x, y) > 0 ? x : std::numeric_limits<double>::quiet_NaN();
    });
    map("ground", "m", [](double x, double) { return 50 - 0.5 * x; });
  }

 private:
  std::string case_text() const {
    return "title = \"" + title +
           "\"\n[terrain.plane]\nextent = [0, 0, 40, 20]\nslope = 10\n"
           "[release]\nbox = [2, 8, 30, 6, 12, 60]\n"
           "[material]\ndensity = 2000\n"
           "[path]\nline = [[1, 10], [39, 10]]\n"
           "[[zone]]\nname = \"west\"\npolygon = [[0, 0], [10, 0], [10, 20], [0, 20]]\n"
           "[numerics]\nspacing = 1\n[run]\nduration = 10\n" +
           keys;
  }
  static void put(const std::filesystem::path& file, const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
  }
};

/// 1 m deep within a rectangle.
inline std::function<double(double, double)> slab(double west, double east, double south,
                                                  double north) {
  return [=](double x, double y) {
    return x > west && x < east && y > south && y < north ? 1.0 : 0.0;
  };
}

}  // namespace sabo
