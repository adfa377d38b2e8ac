#include "run/file_list.hpp"

#include <fmt/format.h>

#include "run/run_maps.hpp"

namespace sabo {

std::vector<PageFile> files_of_run(const Case& c, const Scene& scene) {
  std::vector<PageFile> files{
      {"view/index.html", "the run in 3D, in this browser"},
      {"case.toml", "the case with every default"},
      {"manifest.toml", "version, times, volumes, passes of the solver, checksums of the inputs"}};
  for (const MapKind& kind : map_kinds())
    files.push_back({fmt::format("maps/{}.tif", kind.name),
                     fmt::format("{}, {}", kind.description, kind.unit)});
  files.insert(files.end(),
               {{"maps/ground.tif", "elevation of the ground as the run used it, m"},
                {"maps/rel.tif", "depth of the release, m"},
                {"maps/plan.geojson", "path, structures, bodies, inflows, sections and zones"},
                {"series/front.csv", "position, displacement and velocity of the front"},
                {"series/discharge.csv", "discharge through the sections"},
                {"series/volumes.csv", "released, trapped, beyond, outflow"},
                {"series/energy.csv", "mass and energies"},
                {"series/rest.csv", "moving volume, kinetic energy over its peak, creep"},
                {"series/solver.csv", "time step, speeds, density range, particle counts"},
                {"frames/paraview.pvsm", "all of it for ParaView: File, Load State"},
                {"frames/flow.pvd", "particles as a time series for ParaView"},
                {"frames/surface.pvd", "surface of the flow as a time series for ParaView"},
                {"frames/ground.vtp", "the ground for ParaView"}});
  if (!scene.check_dams().empty())
    files.push_back({"series/filling.csv", "how full the basins behind the dams are"});
  if (!c.zones.empty()) files.push_back({"series/zones.csv", "depth and volume in the zones"});
  if (!c.sections.empty()) {
    files.push_back({"series/sections.csv", "area, depth and speeds at the sections"});
    files.push_back({"series/velocity_profiles.csv", "their speed over the height"});
  }
  if (!c.gauges.empty())
    files.push_back({"series/gauges.csv", "depth, speed and pressure at the gauges"});
  if (!scene.dams.empty() || !scene.bodies.empty()) {
    files.push_back({"frames/bodies.vtp", "structures and bodies for ParaView"});
    files.push_back({"series/loads.csv", "forces and moments on structures and bodies"});
    files.push_back({"series/pressure_profiles.csv", "their forces over the height"});
  }
  return files;
}

}  // namespace sabo
