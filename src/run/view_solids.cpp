#include "run/view_solids.hpp"

#include "run/scene_bodies.hpp"
#include "run/scene_structures.hpp"

namespace sabo {

std::vector<ViewSolid> view_solids(const Case& c, const Scene& scene) {
  std::vector<ViewSolid> solids;
  for (const CheckDam& dam : scene.dams) solids.push_back({dam.name, shown_mesh(dam, scene)});
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    solids.push_back({scene.bodies[b].name(), shown_mesh(c, b, scene)});
  return solids;
}

}  // namespace sabo
