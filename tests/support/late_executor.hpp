#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <vector>

#include "support/late_array.hpp"

#include "backend/device/pair_rows.hpp"

namespace sabo::test {

/// In which order a loop takes its indices. On a card there is none: what comes of a loop must not
/// hang on it.
enum class LoopOrder { forward, backward };

/// Stands in for a card (backend/cuda/cuda_executor.cuh, which says what the members do) with what
/// is hard on code for one: work is done as late as it may be, in loops of either order, and
/// memory holds nothing of use before it is written to.
class LateExecutor {
 public:
  template <class T>
  using Array = LateArray<T, LateMemory>;
  template <class T>
  using StagingArray = LateArray<T, StagingMemory>;

  struct Habits {
    LoopOrder order = LoopOrder::forward;
    std::uint32_t row_shares = 1;  ///< by how many threads a row of pairs is summed up
    int in_memory = no_number;     ///< see spoil()
  };

  LateExecutor() = default;
  explicit LateExecutor(const Habits& habits) : habits_(habits) {}

  template <class F>
  void for_each(std::size_t count, const F& f) const {
    static_assert(std::is_trivially_copyable_v<F>);
    if (count > 0) later([=, this_one = *this] { this_one.loop(count, f); });
  }

  template <class Sum, class F>
  Sum reduce(std::size_t count, const F& f) const {
    if (count > 0) late_stream().wait_for_all();
    return sum_of<Sum>(count, f);
  }
  template <class Sum, class F, class Then>
  void sum_up(std::size_t count, const F& f, const Then& then) const {
    static_assert(std::is_trivially_copyable_v<F> && std::is_trivially_copyable_v<Then>);
    later([=, this_one = *this] { then(this_one.sum_of<Sum>(count, f)); });
  }

  template <class Sweep>
  void sweep(std::size_t count, const Sweep& sweep) const {
    for_each(count, FinishRow<Sweep>{sweep, habits_.row_shares});
  }
  template <class Sum, class Sweep, class Then>
  void sweep_and_sum(std::size_t count, const Sweep& sweep, const Then& then) const {
    sum_up<Sum>(count, FinishRow<Sweep>{sweep, habits_.row_shares}, then);
  }

  template <class T>
  void zero(Array<T>& array, std::size_t count) const {
    array.resize(count);
    later([count, to = array.data()] {
      if (count > 0) std::memset(static_cast<void*>(to), 0, count * sizeof(T));
    });
  }
  template <class T>
  void reserve(Array<T>& array, std::size_t count) const {
    array.resize(count);
    later([count, to = array.data(), with = habits_.in_memory] {
      spoil(to, count * sizeof(T), with);
    });
  }
  template <class T>
  void release(Array<T>& array) const {
    array.resize(0);
  }

  template <class T>
  void upload(const std::vector<T>& from, Array<T>& to) const {
    to.resize(from.size());
    if (!from.empty()) late_stream().wait_for_all();
    std::ranges::copy(from, to.data());
  }
  template <class T>
  void download(const Array<T>& from, std::vector<T>& to) const {
    if (from.size() > 0) late_stream().wait_for_all();
    to.assign(from.data(), from.data() + from.size());
  }
  template <class T>
  void start_download(const Array<T>& from, StagingArray<T>& to) const {
    to.resize(from.size());
    spoil(to.data(), to.size() * sizeof(T));
    copy_later(from, to.data());
  }
  template <class T>
  void copy(const Array<T>& from, Array<T>& to) const {
    to.resize(from.size());
    copy_later(from, to.data());
  }
  template <class T>
  T last(const Array<T>& array) const {
    late_stream().wait_for_all();
    return array.data()[array.size() - 1];
  }

  void sort(Array<std::uint64_t>& keys, Array<std::uint32_t>& values, int bits) const {
    Array<std::uint64_t> sorted_keys;
    Array<std::uint32_t> sorted_values, order;
    sorted_keys.resize(keys.size());
    sorted_values.resize(keys.size());
    order.resize(keys.size());
    later([=, count = keys.size(), key = keys.data(), value = values.data(), place = order.data(),
           to_key = sorted_keys.data(), to_value = sorted_values.data()] {
      const std::uint64_t mask = ~std::uint64_t{0} >> (64 - bits);
      std::iota(place, place + count, 0u);
      std::stable_sort(place, place + count, [&](std::uint32_t a, std::uint32_t b) {
        return (key[a] & mask) < (key[b] & mask);
      });
      for (std::size_t k = 0; k < count; ++k) {
        to_key[k] = key[place[k]];
        to_value[k] = value[place[k]];
      }
    });
    keys = std::move(sorted_keys);
    values = std::move(sorted_values);
  }
  void scan(Array<std::uint64_t>& values) const {
    Array<std::uint64_t> sums;
    sums.resize(values.size());
    later([count = values.size(), value = values.data(), to = sums.data()] {
      std::exclusive_scan(value, value + count, to, std::uint64_t{0});
    });
    values = std::move(sums);
  }

  struct Moment {
    LateStream::Place place;
    std::shared_ptr<std::chrono::steady_clock::time_point> time;
  };
  Moment now() const {
    const auto time = std::make_shared<std::chrono::steady_clock::time_point>();
    later([time] { *time = std::chrono::steady_clock::now(); });
    return {late_stream().place(), time};
  }
  void await(const Moment& moment) const { late_stream().wait_for(moment.place); }
  double seconds_between(const Moment& start, const Moment& end) const {
    await(end);
    return std::chrono::duration<double>(*end.time - *start.time).count();
  }

 private:
  /// All sums over the pairs of a row are there before the first is taken.
  template <class Sweep>
  struct FinishRow {
    Sweep sweep;
    std::uint32_t shares;
    template <class... Sum>
    void operator()(std::size_t row, Sum&... sum) const {
      auto sums = sweep.sums_of(row, {0, shares});
      for (std::uint32_t k = 1; k < shares; ++k) sums.join(sweep.sums_of(row, {k, shares}));
      sweep.finish(row, sums, sum...);
    }
  };

  template <class Work>
  static void later(Work work) {
    late_stream().add(std::move(work));
  }
  template <class T>
  static void copy_later(const Array<T>& from, T* to) {
    later([=, first = from.data(), count = from.size()] { std::copy_n(first, count, to); });
  }

  template <class F>
  void loop(std::size_t count, const F& f) const {
    for (std::size_t k = 0; k < count; ++k)
      f(habits_.order == LoopOrder::forward ? k : count - 1 - k);
  }
  /// Several indices add to one sum; all are joined in one order, whatever that of the loop.
  template <class Sum, class F>
  Sum sum_of(std::size_t count, const F& f) const {
    constexpr std::size_t each = 4;
    std::vector<Sum> sums((count + each - 1) / each);
    loop(sums.size(), [&](std::size_t s) {
      for (std::size_t k = s * each; k < std::min(count, (s + 1) * each); ++k) f(k, sums[s]);
    });
    Sum total;
    for (const Sum& sum : sums) total.join(sum);
    return total;
  }

  Habits habits_;
};

}  // namespace sabo::test
