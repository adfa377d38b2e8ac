#include "base/counted.hpp"

#include <cstddef>

#include <gtest/gtest.h>

namespace sabo {
namespace {

TEST(Counted, HasAnSUnlessThereIsOne) {
  EXPECT_EQ(counted(0, "cell"), "0 cells");
  EXPECT_EQ(counted(std::size_t{1}, "cell"), "1 cell");
  EXPECT_EQ(counted(2, "step"), "2 steps");
}

}  // namespace
}  // namespace sabo
