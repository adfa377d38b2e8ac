#pragma once

#include <vector>

#include "analysis/load_peak.hpp"
#include "analysis/load_profile.hpp"
#include "backend/backend.hpp"
#include "case/load_case.hpp"
#include "run/mean_load.hpp"
#include "run/scene.hpp"
#include "solver/stepper.hpp"

namespace sabo {

/// Adds up the forces on the structures of a scene, step by step.
class LoadAccount {
 public:
  LoadAccount(const LoadCase& settings, const Scene& scene, const FlowModel& model);

  /// To be called first, with the time at which the run starts (s).
  void start(double time);

  /// After every step.
  void after_step(const Stepper& stepper, const StepReport& report, Backend& backend);

  /// Since the last call; one entry per structure.
  std::vector<MeanLoad> take_means(const Stepper& stepper, Backend& backend);

  template <class Archive>
  void archive(Archive& a) {
    a(last_taken_);
    a.fixed(accounts_);
  }

 private:
  struct Account {
    Vec3d base;  ///< about which moments are
    LoadPeak peak;
    LoadProfile profile;
    BodyLoad taken;  ///< impulse by the last call

    template <class Archive>
    void archive(Archive& a) {
      a(peak, profile, taken);
    }
  };

  double filter_;          // of the peaks, s
  double last_taken_ = 0;  // s
  std::vector<Account> accounts_;
};

}  // namespace sabo
