#include "base/host_loops.hpp"

#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace sabo {
namespace {

TEST(HostLoops, FewThingsAreDoneOnceEachAndMayThrow) {
  for (const int threads : {1, 3}) {
    std::vector<int> done(50);
    over_few(done.size(), threads, [&](std::size_t i) { ++done[i]; });
    EXPECT_EQ(done, std::vector<int>(50, 1));
    struct None {
      void join(const None&) {}
    };
    EXPECT_THROW(blocked_sum<None>(5000, threads,
                                   [](std::size_t i, None&) {
                                     if (i == 4321) throw std::runtime_error("no room");
                                   }),
                 std::runtime_error);
    EXPECT_THROW(over_few(done.size(), threads,
                          [](std::size_t i) {
                            if (i % 7 == 3) throw std::runtime_error("no room");
                          }),
                 std::runtime_error);
  }
}

// Added in another order they round otherwise; blocks are as they are for any number of threads.
TEST(HostLoops, SumsHaveTheSameBitsForAnyNumberOfThreads) {
  struct Sum {
    double value = 0;
    void join(const Sum& other) { value += other.value; }
  };
  const auto sum = [](int threads) {
    return blocked_sum<Sum>(
               10'000, threads,
               [](std::size_t i, Sum& s) { s.value += 1e-3 * static_cast<double>(i % 17); })
        .value;
  };
  const double one = sum(1);
  EXPECT_NEAR(one, 10'000 * 8e-3, 0.1);
  for (const int threads : {2, 3, 7}) EXPECT_EQ(sum(threads), one);
}

}  // namespace
}  // namespace sabo
