#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "verify/claim.hpp"

#include "case/material_case.hpp"
#include "case/numerics_case.hpp"
#include "io/output/svg_chart.hpp"
#include "solver/flow_model.hpp"

namespace sabo {

/// How much is computed: `quick` is coarse and short, to see within seconds that nothing broke;
/// `full` is what the gates are for; `extended` adds resolutions that take hours.
enum class Effort { quick, full, extended };
template <>
struct Words<Effort> {
  static constexpr std::array<std::string_view, 3> list{"quick", "full", "extended"};
};

struct VerifySettings {
  Method method = Method::fast;
  Effort effort = Effort::full;
  int threads = 1;
  bool again = false;                            ///< also what a run folder of this version holds
  std::filesystem::path folder = "sabo-verify";  ///< for the run folders of cases that make some
  /// Told now and then what share of the work is done; may throw to end the case early.
  std::function<void(double share)> on_progress = [](double) {};

  /// Breaks a term of every model on purpose: what a case expects stays, so it has to notice.
  std::function<void(FlowModel&)> alter = [](FlowModel&) {};

  bool is_quick() const { return effort == Effort::quick; }

  /// The setting of the method in which it is verified. That of `paper` is the accurate one, not
  /// its default, which is the paper read literally.
  NumericsCase numerics() const;

  /// flow_model(), altered. Cases that lay out their flow by hand take their models from here.
  FlowModel model(const MaterialCase& material, const NumericsCase& numerics,
                  double release_depth) const;
};

/// What a case found out.
struct Verdict {
  std::vector<Claim> claims;
  std::vector<LineChart> charts;
  std::vector<std::string> remarks;  ///< what the numbers do not say by themselves

  bool holds() const {
    for (const Claim& claim : claims)
      if (!claim.holds()) return false;
    return !claims.empty();
  }
};

/// A case with a known outcome.
struct Verification {
  std::string_view name;       ///< a word for the command line
  std::string_view title;      ///< one line
  std::string_view reference;  ///< where the expected values come from
  std::vector<Method> methods;
  Verdict (*run)(const VerifySettings&);
  std::string_view others = "";  ///< what other codes are known to reach, with the source
};

/// All cases, simple ones first.
const std::vector<Verification>& verifications();

}  // namespace sabo
