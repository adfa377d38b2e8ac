#pragma once

#include <cstdint>

#include "base/host_device.hpp"

namespace sabo {

/// 1 for each index that is kept, and a last 0, so that the sums before each tell places and
/// number.
template <class Keep>
struct MarkKept {
  Keep keep;
  std::size_t count;
  std::uint64_t* marks;
  SABO_HD void operator()(std::size_t i) const { marks[i] = i < count && keep(i) ? 1 : 0; }
};

struct WriteKept {
  const std::uint64_t* places;
  std::uint32_t* rows;
  SABO_HD void operator()(std::size_t i) const {
    if (places[i + 1] != places[i]) rows[places[i]] = static_cast<std::uint32_t>(i);
  }
};

/// The indices below `count` with keep(i), in order.
template <class Executor, class Keep>
void list_kept(const Executor& on, std::size_t count, const Keep& keep,
               typename Executor::template Array<std::uint32_t>& rows) {
  typename Executor::template Array<std::uint64_t> places;
  on.reserve(places, count + 1);
  on.for_each(count + 1, MarkKept<Keep>{keep, count, places.data()});
  on.scan(places);
  on.reserve(rows, on.last(places));
  on.for_each(count, WriteKept{places.data(), rows.data()});
}

}  // namespace sabo
