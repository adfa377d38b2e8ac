#pragma once

#include "base/host_device.hpp"

namespace sabo {

/// The first index of [low, high) that is not before what is looked for: std::partition_point on
/// hosts and devices. Those with is_before(index) come first.
template <class Index, class IsBefore>
SABO_HD Index bisect(Index low, Index high, const IsBefore& is_before) {
  while (low < high) {
    const Index middle = low + (high - low) / 2;
    if (is_before(middle))
      low = middle + 1;
    else
      high = middle;
  }
  return low;
}

}  // namespace sabo
