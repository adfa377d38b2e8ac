#pragma once

#include <memory>
#include <vector>

#include "case/case.hpp"
#include "run/scene.hpp"
#include "solver/domain.hpp"
#include "solver/stepper.hpp"
#include "terrain/ground.hpp"

namespace sabo {

/// Of the ground under a flow.
GroundSettings ground_settings(const FlowModel& model);

/// The flow of a case, ready to be stepped. `scene` must outlive it.
class Flow {
 public:
  Flow(const Case& c, const Scene& scene) : Flow(c, scene, scene.release, scene.inflows) {}
  /// The same with other particles, e.g. a part of the release, and other inflows.
  Flow(const Case& c, const Scene& scene, const Particles& fluid,
       const std::vector<InflowPlan>& inflows = {});

  const FlowModel& model() const { return model_; }
  Domain& domain() { return domain_; }
  Backend& backend() { return *backend_; }
  Stepper& stepper() { return *stepper_; }

  template <class Archive>
  void archive(Archive& a) {
    a(*backend_, *stepper_, domain_);
  }

 private:
  FlowModel model_;  ///< at the start
  Ground ground_;
  Domain domain_;
  std::unique_ptr<Backend> backend_;
  std::unique_ptr<Stepper> stepper_;
};

}  // namespace sabo
