#pragma once

#include <cmath>
#include <string>

#include "verify/claim.hpp"

#include "analysis/energy.hpp"
#include "backend/backend.hpp"
#include "solver/stepper.hpp"

namespace sabo {

/// The energy of a flow that nothing enters or leaves, from the moment it is let go.
class EnergyBooks {
 public:
  explicit EnergyBooks(Backend& flow) : start_(energy_in(flow)) {}

  /// What is too much (negative: missing) over the potential energy given up.
  double imbalance(Backend& flow, const Stepper& stepper) const {
    return energy_balance(start_, energy_in(flow), {}, stepper.dissipated(),
                          flow.heat().numerical.total())
        .imbalance();
  }

 private:
  static Energy energy_in(Backend& flow) {
    const FlowModel& model = flow.model();
    return energy_of(flow.fluid(), model.gravity, model.state, !model.tension_at_surface);
  }

  Energy start_;
};

/// That the books close: what is missing, or too much, over the potential energy given up.
inline Claim claim_of_books(const std::string& where, double imbalance) {
  return Claim::at_most(where + "energy that is not accounted for, over that released", "",
                        std::abs(imbalance), 0.005);
}

}  // namespace sabo
