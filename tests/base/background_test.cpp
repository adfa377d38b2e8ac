#include "base/background.hpp"

#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace sabo {
namespace {

void linger() { std::this_thread::sleep_for(std::chrono::milliseconds(20)); }

TEST(Background, DoesOnePieceAfterTheOther) {
  std::vector<int> done;
  Background background;
  for (int piece = 0; piece < 3; ++piece) {
    background.start([&done, piece] {
      linger();
      done.push_back(piece);
    });
  }
  background.settle();
  EXPECT_EQ(done, (std::vector{0, 1, 2}));
}

TEST(Background, ThrowsOnceWhatItsWorkThrew) {
  Background background;
  background.start([] { throw std::runtime_error("no room"); });
  EXPECT_THROW(background.settle(), std::runtime_error);
  EXPECT_NO_THROW(background.settle());
  bool is_done = false;
  background.start([] { throw std::runtime_error("no room"); });
  EXPECT_THROW(background.start([&] { is_done = true; }), std::runtime_error);
  background.settle();
  EXPECT_FALSE(is_done);
}

TEST(Background, EndsBeforeItIsGone) {
  bool is_done = false;
  {
    Background background;
    background.start([&] {
      linger();
      is_done = true;
    });
  }
  EXPECT_TRUE(is_done);
}

}  // namespace
}  // namespace sabo
