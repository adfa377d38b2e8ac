#include "run/flow.hpp"

#include <cstdint>

#include "solver/flow_model.hpp"
#include "solver/make_backend.hpp"
#include "solver/make_stepper.hpp"

namespace sabo {
namespace {

std::unique_ptr<Backend> loaded_backend(const Case& c, const Particles& fluid,
                                        const FlowModel& model) {
  auto backend = make_backend(c.numerics.backend, model);
  backend->fluid() = fluid;
  return backend;
}

}  // namespace

GroundSettings ground_settings(const FlowModel& model) {
  return {model.spacing, model.wall_layers(), model.state.rho0};
}

Flow::Flow(const Case& c, const Scene& scene, const Particles& fluid,
           const std::vector<InflowPlan>& inflows)
    : model_(flow_model(c.material, c.numerics, scene.greatest_depth())),
      ground_(*scene.surface, scene.dams, ground_settings(model_), scene.bodies),
      domain_(ground_, inflows, static_cast<std::uint32_t>(fluid.size())),
      backend_(loaded_backend(c, fluid, model_)),
      stepper_(make_stepper(c.numerics, *backend_, &domain_)) {}

}  // namespace sabo
