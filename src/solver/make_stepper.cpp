#include "solver/make_stepper.hpp"

#include "solver/fast_stepper.hpp"
#include "solver/flow_model.hpp"
#include "solver/paper_stepper.hpp"

namespace sabo {

std::unique_ptr<Stepper> make_stepper(const NumericsCase& numerics, Backend& backend,
                                      Domain* domain) {
  const FlowModel& model = backend.model();
  if (numerics.method == Method::fast)
    return std::make_unique<FastStepper>(backend, fast_rule(numerics, model), domain);
  return std::make_unique<PaperStepper>(backend, time_step_rule(numerics, model), domain);
}

}  // namespace sabo
