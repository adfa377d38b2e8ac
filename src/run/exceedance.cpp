#include "run/exceedance.hpp"

#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/gis/crs.hpp"
#include "io/gis/raster_file.hpp"
#include "io/gis/write_raster.hpp"
#include "io/output/file.hpp"
#include "io/output/map_picture.hpp"

namespace sabo {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view map_prefix = "exceedance_";

struct Maps {
  std::string crs;
  Raster ground;
  std::vector<Raster> depths;
};

Maps read_maps(const std::vector<fs::path>& runs) try {
  Maps maps;
  for (const fs::path& run : runs) {
    const RasterFile file(run / "maps" / "pfd.tif", run.filename().string());
    if (maps.depths.empty()) {
      maps.crs = wkt_of(file.crs());
      maps.ground = RasterFile(run / "maps" / "ground.tif", run.filename().string()).read();
    }
    maps.depths.push_back(file.read());
    if (!(maps.depths.back().grid == maps.depths.front().grid))
      throw RunError(run.string() + " has maps of another extent or cell size than the other runs");
  }
  return maps;
} catch (const CaseError& error) {
  throw RunError(error.what());
}

std::vector<ColourStep> share_steps() {
  // ColorBrewer's YlOrBr, which any colour vision tells apart.
  return {{0.25, {255, 247, 188}, "under 25 %"},
          {0.5, {254, 196, 79}, "25 to 50 %"},
          {0.75, {217, 95, 14}, "50 to 75 %"},
          {0, {102, 37, 6}, "75 % or more"}};
}

}  // namespace

Raster share_above(const std::vector<Raster>& maps, double limit) {
  Raster share(maps.front().grid);
  for (std::size_t cell = 0; cell < share.values.size(); ++cell) {
    double above = 0, known = 0;
    for (const Raster& map : maps) {
      if (std::isnan(map.values[cell])) continue;
      ++known;
      if (map.values[cell] > limit) ++above;
    }
    share.values[cell] = known > 0 ? above / known : Raster::no_data;
  }
  return share;
}

std::vector<PagePicture> write_exceedance(const std::vector<fs::path>& runs,
                                          const std::vector<double>& depths, const Case& c,
                                          const fs::path& folder) {
  // Those of an earlier sweep in this folder, of other depths perhaps.
  for (const char* name : {"maps", "pictures"}) remove_named(folder / name, map_prefix);
  if (depths.empty()) return {};
  const Maps maps = read_maps(runs);
  for (const char* name : {"maps", "pictures"}) make_folder(folder / name);
  std::vector<PagePicture> pictures;
  for (const double depth : depths) {
    const Raster share = share_above(maps.depths, depth);
    const std::string name = fmt::format("{}{:g}m", map_prefix, depth);
    write_raster(
        folder / "maps" / (name + ".tif"), share,
        {maps.crs,
         fmt::format("share of {} runs whose greatest depth was above {:g} m", runs.size(), depth),
         "",
         {}});
    MapPicture picture{fmt::format("Share of {} runs deeper than {:g} m", runs.size(), depth),
                       c.note, "share of the runs"};
    picture.view = view_around(share, 0);
    picture.steps = share_steps();
    const std::string svg = fmt::format("pictures/{}.svg", name);
    write_file_atomically(folder / svg, map_svg(picture, maps.ground, share));
    pictures.push_back({{svg},
                        fmt::format("Share of the runs whose greatest depth was above {:g} m "
                                    "(maps/{}.tif)",
                                    depth, name),
                        true});
  }
  return pictures;
}

}  // namespace sabo
