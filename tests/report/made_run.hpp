#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "report/write_report.hpp"
#include "support/temporary_folder.hpp"

#include "io/gis/write_raster.hpp"
#include "io/output/plan_file.hpp"

namespace sabo {

/// A report, which is too long to be printed by a test that fails.
struct ReportText {
  std::string html;
  friend void PrintTo(const ReportText&, std::ostream* out) { *out << "the report"; }
};

/// A run folder made by hand: a slope of 20 x 10 cells of 2 m, a wall across it at x = 20, a
/// section at x = 30, and series of three rows whose peaks are known.
class MadeRun {
 public:
  explicit MadeRun(const std::string& title = "A valley") {
    write("manifest.toml", manifest("finished", ""));
    write("case.toml", "title = \"" + title + R"("
terrain.plane.extent = [0, 0, 40, 20]
release.box = [0, 0, 0, 4, 4, 4]
material.preset = "glass_beads"
numerics.spacing = 0.5
run.duration = 2
[[structure]]
name = "wall"
line = [[20, 0], [20, 20]]
height = 3
thickness = 2
[[section]]
name = "s1"
line = [[30, 0], [30, 20]]
[[zone]]
name = "field"
polygon = [[32, 0], [38, 0], [38, 20]]
observed = 0.5
source = "survey"
)");
    write_maps();
    write_series();
  }

  void write(const std::string& file, const std::string& text) const {
    const std::filesystem::path path = root() / file;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << text;
  }
  void remove(const std::string& file) const { std::filesystem::remove_all(root() / file); }
  std::filesystem::path root() const { return folder_ / "run"; }

  ReportText report(Language language = Language::en,
                    const std::filesystem::path& other = {}) const {
    std::ostringstream text;
    text << std::ifstream(write_report(root(), {"", language, other, 0.1}), std::ios::binary)
                .rdbuf();
    return {text.str()};
  }

  static std::string manifest(const std::string& end, const std::string& reason) {
    return "[run]\nend = \"" + end + "\"\nreason = \"" + reason + R"("
version = "0.1.0+test"
started = "2026-01-02T03:04:05Z"
wall_s = 1.5
simulated_s = 2
particles = 512
[[volumes]]
released = 64
outflow = 4
put_back = 3
dam = "wall"
trapped = 40
beyond = 20
[[zones]]
zone = "field"
mean_wet = 0.8
mean_all = 0.2
greatest = 1.25
wet_area = 60
volume = 48
[maps]
raster_volume = 60
particle_volume = 60
[resolution]
wet_area = 432
median_layers = 3.25
thin_share = 0.7
barely_share = 0.1
[motion]
at_rest = true
moving_volume = 0
[energy]
released_J = 2e6
kinetic_J = 5e5
dissipated_J = 1.4e6
imbalance = 0.05
[quantities]
"front run-out [m]" = 27.5
"peak front speed [m/s]" = 9.75
"arrival at wall [s]" = 1.25
[release]
volume = 64
area = 16
mean_depth = 4
greatest_depth = 4
[inputs]
"dem.tif" = "0123abcd"
)";
  }

 private:
  void write_maps() const {
    const Grid grid{.columns = 20, .rows = 10, .north = 20, .dx = 2, .dy = 2};
    std::filesystem::create_directories(root() / "maps");
    const auto map = [&](const char* name, const char* unit, auto value) {
      Raster raster(grid);
      for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column)
          raster.at(column, row) = value(grid.x_of(column), grid.y_of(row));
      write_raster(root() / "maps" / name, raster, {"", name, unit});
    };
    const auto within = [](double y, double value) { return y > 4 && y < 16 ? value : 0.0; };
    map("ground.tif", "m", [](double x, double) { return 30 - x / 2; });
    map("pfd.tif", "m", [&](double, double y) { return within(y, 1.625); });
    map("dep.tif", "m", [&](double x, double y) { return x < 20 ? within(y, 1) : 0; });
    map("pfv.tif", "m/s", [&](double x, double y) { return within(y, x / 4); });
    map("ppr.tif", "kPa", [&](double, double y) { return within(y, 20); });
    map("tarr.tif", "s", [&](double x, double) { return x / 20; });
    map("res.tif", "particles", [&](double, double y) { return within(y, 3.25); });
    map("rel.tif", "m", [](double x, double y) { return x < 4 && y < 4 ? 4.0 : 0.0; });
    write_plan(root() / "maps" / "plan.geojson",
               {{MapLine::Kind::path, "", {{{1, 10, 0}, {39, 10, 0}}, false}},
                {MapLine::Kind::dam, "wall", {{{20, 0, 23}, {20, 20, 23}}, true}},
                {MapLine::Kind::section, "s1", {{{30, 0, 0}, {30, 20, 0}}, false}}},
               "");
  }

  void write_series() const {
    write("series/discharge.csv",
          "time [s],s1 net discharge [m3/s],s1 forward volume [m3],s1 backward volume [m3]\n"
          "0,0,0,0\n1,23.45,11.5,0\n2,5,25,0.75\n");
    write("series/front.csv",
          "time [s],position [m],displacement [m],velocity [m/s]\n"
          "0,1,0,0\n1,10.75,9.75,9.75\n2,28.5,27.5,17.75\n");
    write(
        "series/volumes.csv",
        "time [s],released [m3],outflow [m3],put back [count],wall trapped [m3],wall beyond [m3]\n"
        "0,64,0,0,64,0\n1,64,0,1,50,14\n2,64,4,3,40,20\n");
    write("series/energy.csv",
          "time [s],kinetic [J],dissipated [J],numerical [J],left the map [J]\n"
          "0,0,0,0,0\n2,5e5,1.4e6,0,0\n");
    write("series/solver.csv",
          "time [s],lowest density ratio,highest density "
          "ratio\n0,1,1\n1,0.991,1.0234\n2,0.995,1.01\n");
  }

  TemporaryFolder folder_;
};

}  // namespace sabo
