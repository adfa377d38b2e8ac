#include <memory>
#include <string>

#include "support/device_on_host.hpp"
#include "support/random_flow.hpp"
#include "support/sleepy_block.hpp"
#include <gtest/gtest.h>

// On a card the indices of a loop are taken in no order. What reads what another index of its loop
// writes gives other bits from end to begin than from begin to end.

namespace sabo {
namespace {

using test::LoopOrder;

std::unique_ptr<Backend> in(LoopOrder order, const FlowModel& model) {
  return std::make_unique<test::DeviceOnHost>(model, test::LateExecutor(order));
}

/// Puts some particles and one more above all others.
void lift(Particles& some) {
  some.append(some, {0});
  some.id.back() = 1000;
  some.position.back().z += 1;
  for (Vec3d& x : some.position) x.z += 1;
}

TEST(LoopOrder, IsNothingToAFlowWithAllThatThereIs) {
  for (const Method method : test::both_methods)
    for (const bool is_driven : {false, true}) {
      std::string states[2];
      for (const LoopOrder order : {LoopOrder::forward, LoopOrder::backward}) {
        test::SleepyBlock flow(in(order, test::sleepy_mud()), method, is_driven);
        flow.go(60);
        EXPECT_GT(norm(flow.backend->body_loads().at(0).force), 0);
        if (method == Method::fast && !is_driven) {
          EXPECT_GT(flow.backend->asleep_count(), 0u);
        }
        flow.backend->take_out({7, 40});
        flow.backend->change_rows({5, 80}, lift);
        flow.go(20);
        EXPECT_EQ(flow.backend->fluid_count(), 215u);
        states[static_cast<int>(order)] = flow.state();
      }
      EXPECT_TRUE(states[0] == states[1]) << word_of(method) << is_driven;
    }
}

TEST(LoopOrder, IsNothingToAnyFlow) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    const test::RandomFlow flow(seed);
    std::string states[2];
    for (const LoopOrder order : {LoopOrder::forward, LoopOrder::backward}) {
      test::Moving moving(in(order, flow.model), flow, seed % 4 != 0);
      moving.go(3);
      moving.backend->pass_times().clear();
      states[static_cast<int>(order)] = test::archived(*moving.backend);
    }
    EXPECT_TRUE(states[0] == states[1]) << seed << " " << word_of(flow.method);
  }
}

}  // namespace
}  // namespace sabo
