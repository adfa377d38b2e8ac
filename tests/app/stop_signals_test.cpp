#include "app/stop_signals.hpp"

#include <csignal>
#include <cstdlib>

#include <gtest/gtest.h>

namespace sabo {
namespace {

// Each in a process of its own, because signal handlers stay.

TEST(StopSignals, TheFirstOnlySetsTheFlag) {
  const auto stop_once = [](int signal) {
    const std::atomic<bool>& stop = catch_stop_signals();
    if (stop) std::exit(1);
    std::raise(signal);
    std::exit(stop ? 42 : 1);
  };
  EXPECT_EXIT(stop_once(SIGINT), testing::ExitedWithCode(42), "Stopping");
  EXPECT_EXIT(stop_once(SIGTERM), testing::ExitedWithCode(42), "Stopping");
}

TEST(StopSignals, TheSecondInterruptEndsAtOnce) {
  const auto stop_twice = [] {
    catch_stop_signals();
    std::raise(SIGINT);
    std::raise(SIGINT);
    std::exit(1);
  };
  EXPECT_EXIT(stop_twice(), testing::ExitedWithCode(130), "Stopping");
}

}  // namespace
}  // namespace sabo
