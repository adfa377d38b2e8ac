#pragma once

#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "base/describe.hpp"

namespace sabo {

/// How a measured value must lie to what is expected.
enum class GateKind {
  within_share,  ///< differs by no more than a share of what is expected
  within,        ///< differs by no more than a distance, in the unit of the value
  at_most,       ///< no greater than what is expected
  at_least,      ///< no less
  none,          ///< it is told beside what others found
};

template <>
struct Words<GateKind> {
  static constexpr std::array<std::string_view, 5> list{"within_share", "within", "at_most",
                                                        "at_least", "none"};
};

/// One number that a case measures.
struct Claim {
  std::string what;
  std::string unit;  ///< "" for a pure number
  double measured = 0;
  double expected = 0;
  GateKind gate = GateKind::within_share;
  double margin = 0;  ///< of the first two kinds

  /// Whether the gate is met; a value that is not finite meets none.
  bool holds() const {
    const double difference = std::abs(measured - expected);
    switch (gate) {
      case GateKind::within_share:
        return difference <= margin * std::abs(expected);
      case GateKind::within:
        return difference <= margin;
      case GateKind::at_most:
        return measured <= expected;
      case GateKind::at_least:
        return measured >= expected;
      case GateKind::none:
        return std::isfinite(measured);
    }
    return false;
  }

  static Claim within_share(std::string what, std::string unit, double measured, double expected,
                            double share) {
    return {std::move(what), std::move(unit), measured, expected, GateKind::within_share, share};
  }
  static Claim within(std::string what, std::string unit, double measured, double expected,
                      double distance) {
    return {std::move(what), std::move(unit), measured, expected, GateKind::within, distance};
  }
  static Claim told(std::string what, std::string unit, double measured, double others) {
    return {std::move(what), std::move(unit), measured, others, GateKind::none};
  }
  static Claim at_most(std::string what, std::string unit, double measured, double most) {
    return {std::move(what), std::move(unit), measured, most, GateKind::at_most};
  }
  static Claim at_least(std::string what, std::string unit, double measured, double least) {
    return {std::move(what), std::move(unit), measured, least, GateKind::at_least};
  }
};

}  // namespace sabo
