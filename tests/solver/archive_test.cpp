#include <algorithm>
#include <string>
#include <vector>

#include "support/archives.hpp"
#include "support/backends.hpp"
#include "support/sleepy_block.hpp"
#include <gtest/gtest.h>

// A flow goes on with the same bits from an archived state, on every backend.

namespace sabo {
namespace {

class Archived : public test::OnBackend {
 protected:
  static test::SleepyBlock block(Method method, bool is_driven) {
    return {test::make_backend(GetParam(), test::sleepy_mud()), method, is_driven};
  }
};

INSTANTIATE_TEST_SUITE_P(On, Archived, testing::ValuesIn(test::all_backends),
                         test::name_of_backend);

TEST_P(Archived, FlowsGoOnWithTheSameBits) {
  for (const Method method : test::both_methods)
    for (const bool is_driven : {false, true}) {
      test::SleepyBlock whole = block(method, is_driven);
      whole.go(60);
      const std::string stepper = test::archived(*whole.stepper);
      const std::string backend = test::archived(*whole.backend);
      whole.go(60);

      test::SleepyBlock resumed = block(method, is_driven);
      test::restore(*resumed.stepper, stepper);
      test::restore(*resumed.backend, backend);
      resumed.go(60);
      EXPECT_TRUE(resumed.state() == whole.state()) << word_of(method) << is_driven;
      if (method == Method::fast && !is_driven) {
        EXPECT_GT(whole.backend->asleep_count(), 0u);
      }
      EXPECT_GT(norm(whole.backend->body_loads().at(0).force), 0);
    }
}

TEST_P(Archived, StatesThatCannotBeAreRefused) {
  test::SleepyBlock whole = block(Method::fast, false);
  whole.go(2);
  whole.backend->fluid().position[3].x = 1e300;
  const std::string backend = test::archived(*whole.backend);
  test::SleepyBlock resumed = block(Method::fast, false);
  EXPECT_THROW(test::restore(*resumed.backend, backend), RunError);
}

}  // namespace
}  // namespace sabo
