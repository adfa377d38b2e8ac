#include <memory>
#include <string>

#include "support/device_on_host.hpp"
#include "support/random_flow.hpp"
#include "support/sleepy_block.hpp"
#include <gtest/gtest.h>

// On a card the indices of a loop are taken in no order, and memory holds whatever was there
// before. What reads what another index of its loop writes gives other bits from end to begin than
// from begin to end; what reads what nobody wrote gives others among large numbers than among
// not-a-numbers.

namespace sabo {
namespace {

constexpr test::LateExecutor::Habits forward{test::LoopOrder::forward, 1, test::no_number};
constexpr test::LateExecutor::Habits backward{test::LoopOrder::backward, 1, 0x7f};

/// As a card with few particles.
test::LateExecutor::Habits sharing(test::LateExecutor::Habits habits) {
  habits.row_shares = 32;
  return habits;
}

std::unique_ptr<Backend> on_host(const test::LateExecutor::Habits& habits, const FlowModel& model) {
  return std::make_unique<test::DeviceOnHost>(model, test::LateExecutor(habits));
}

/// Puts some particles and one more above all others.
void lift(Particles& some) {
  some.append(some, {0});
  some.id.back() = 1000;
  some.position.back().z += 1;
  for (Vec3d& x : some.position) x.z += 1;
}

/// After steps in which particles come and go.
std::string state_after(const test::LateExecutor::Habits& habits, Method method, bool is_driven) {
  test::SleepyBlock flow(on_host(habits, test::sleepy_mud()), method, is_driven);
  flow.go(60);
  EXPECT_GT(norm(flow.backend->body_loads().at(0).force), 0);
  if (method == Method::fast && !is_driven) {
    EXPECT_GT(flow.backend->asleep_count(), 0u);
  }
  flow.backend->take_out({7, 40});
  flow.backend->change_rows({5, 80}, lift);
  flow.go(20);
  EXPECT_EQ(flow.backend->fluid_count(), 215u);
  return flow.state();
}

TEST(LoopOrderAndFormerMemory, AreNothingToAFlowWithAllThatThereIs) {
  for (const Method method : test::both_methods)
    for (const bool is_driven : {false, true}) {
      EXPECT_TRUE(state_after(forward, method, is_driven) ==
                  state_after(backward, method, is_driven));
      EXPECT_TRUE(state_after(sharing(forward), method, is_driven) ==
                  state_after(sharing(backward), method, is_driven));
    }
}

TEST(LoopOrderAndFormerMemory, AreNothingToAnyFlow) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    const test::RandomFlow flow(seed);
    const auto state = [&](const test::LateExecutor::Habits& habits) {
      test::Moving moving(on_host(habits, flow.model), flow, seed % 4 != 0);
      moving.go(3);
      moving.backend->pass_times().clear();
      return test::archived(*moving.backend);
    };
    EXPECT_TRUE(state(forward) == state(backward)) << seed << " " << word_of(flow.method);
  }
}

}  // namespace
}  // namespace sabo
