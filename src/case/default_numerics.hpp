#pragma once

#include "case/numerics_case.hpp"

namespace sabo {

/// Visits keys as the reader of a case file that gives none of them.
struct NothingGiven {
  static constexpr bool sets_members = true;
  template <class T>
  void operator()(const Key& /*key*/, T& /*member*/) const {}
};

/// The numerics of a case that names no more than its method.
inline NumericsCase default_numerics(Method method) {
  NumericsCase numerics;
  numerics.method = method;
  numerics.describe(NothingGiven{});
  return numerics;
}

}  // namespace sabo
