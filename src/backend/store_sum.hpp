#pragma once

#include "base/host_device.hpp"

namespace sabo {

/// What becomes of a sum that is wanted later: it is kept.
template <class Sum>
struct StoreSum {
  Sum* to;
  SABO_HD void operator()(const Sum& sum) const { *to = sum; }
};

}  // namespace sabo
