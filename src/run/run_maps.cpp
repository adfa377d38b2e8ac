#include "run/run_maps.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "analysis/bed_normal.hpp"
#include "io/gis/write_raster.hpp"
#include "run/scene_lines.hpp"

namespace sabo {
namespace {

using Bare = MapKind::Bare;

constexpr double little = 0.01;  // m/s, kPa, kN/m

Raster in_kilo(Raster raster) {
  for (double& value : raster.values) value /= 1000;
  return raster;
}

template <Raster RunMaps::*member>
Raster as_is(const RunMaps& maps, const Raster&) {
  return maps.*member;
}

template <Raster RunMaps::*member>
Raster kilo(const RunMaps& maps, const Raster&) {
  return in_kilo(maps.*member);
}

template <Raster RunMaps::*member>
Raster normal_to_bed(const RunMaps& maps, const Raster& ground) {
  return bed_normal_thickness(maps.*member, ground);
}

constexpr std::array kinds{
    MapKind{"dep", "Depth at the end of the run", "depth", "m",
            "vertical depth at the end of the run", false, Bare::up_to_wet_depth, "deposit",
            as_is<&RunMaps::deposit>},
    MapKind{"pfd", "Greatest depth", "depth", "m", "greatest vertical depth", false,
            Bare::up_to_wet_depth, "peak_depth", as_is<&RunMaps::peak_depth>},
    MapKind{"pfv", "Greatest speed", "speed", "m/s",
            "greatest mass-weighted mean speed of the column", false, Bare::up_to_little,
            "peak_speed", as_is<&RunMaps::peak_speed>},
    MapKind{"ppr", "Greatest pressure", "pressure", "kPa",
            "greatest pressure of a particle in the column", true, Bare::up_to_little,
            "peak_pressure", kilo<&RunMaps::peak_pressure>},
    MapKind{"pmf", "Greatest momentum flux", "density x depth x speed²", "kN/m",
            "greatest momentum flux per width, density x depth x speed² of the column", true,
            Bare::up_to_little, "peak_momentum", kilo<&RunMaps::peak_momentum>},
    MapKind{"det", "Thickness at the end, normal to the ground", "thickness", "m",
            "thickness normal to the ground at the end of the run", false, Bare::up_to_wet_depth,
            nullptr, normal_to_bed<&RunMaps::deposit>},
    MapKind{"pft", "Greatest thickness, normal to the ground", "thickness", "m",
            "greatest thickness normal to the ground", false, Bare::up_to_wet_depth, nullptr,
            normal_to_bed<&RunMaps::peak_depth>},
    MapKind{"tarr", "Arrival", "time", "s", "time of arrival", true, Bare::without_data, "arrival",
            as_is<&RunMaps::arrival>},
    MapKind{"res", "Resolution", "depth over spacing", "particles",
            "greatest vertical depth over the particle spacing", true, Bare::without_data, nullptr,
            as_is<&RunMaps::layers>},
};

}  // namespace

double MapKind::threshold(double wet_depth) const {
  return bare == Bare::up_to_wet_depth ? wet_depth : bare == Bare::up_to_little ? little : 0;
}

std::span<const MapKind> map_kinds() { return kinds; }

const MapKind* map_kind(std::string_view name) {
  const auto* const found =
      std::ranges::find_if(kinds, [name](const MapKind& kind) { return kind.name == name; });
  return found == kinds.end() ? nullptr : found;
}

void write_maps(const RunMaps& maps, const Case& c, const Scene& scene, const RunFolder& folder) {
  const Raster& ground = scene.surface->elevation();
  for (const MapKind& kind : map_kinds()) {
    const std::string where =
        kind.is_of_wet_cells ? fmt::format(", where the flow is deeper than {:g} m", maps.wet_depth)
                             : "";
    RasterInfo info{scene.frame.crs, kind.description + where, kind.unit};
    if (!c.note.empty()) info.metadata["note"] = c.note;
    write_raster(folder.maps() / fmt::format("{}.tif", kind.name),
                 in_crs(kind.values(maps, ground), scene.frame), info);
  }
}

}  // namespace sabo
