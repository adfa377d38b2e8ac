#include "verify/claim.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace sabo {
namespace {

TEST(Claim, HoldsOnItsGateAndFailsBeyond) {
  const auto share = [](double measured) {
    return Claim::within_share("", "", measured, 200, 0.05).holds();
  };
  EXPECT_TRUE(share(190) && share(210));
  EXPECT_FALSE(share(189.9) || share(210.1));
  // A share of a negative value is a distance as well.
  EXPECT_TRUE(Claim::within_share("", "", -1.9, -2, 0.06).holds());

  EXPECT_TRUE(Claim::within("", "m", 1.5, 1, 0.5).holds());
  EXPECT_FALSE(Claim::within("", "m", 0.4, 1, 0.5).holds());
  EXPECT_TRUE(Claim::at_most("", "", 3, 3).holds());
  EXPECT_FALSE(Claim::at_most("", "", 3.1, 3).holds());
  EXPECT_TRUE(Claim::at_least("", "", 3, 3).holds());
  EXPECT_FALSE(Claim::at_least("", "", 2.9, 3).holds());
}

TEST(Claim, FailsWithoutANumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(Claim::within_share("", "", nan, 1, 1e9).holds());
  EXPECT_FALSE(Claim::within("", "", nan, 1, 1e9).holds());
  EXPECT_FALSE(Claim::at_most("", "", nan, 1e9).holds());
  EXPECT_FALSE(Claim::at_least("", "", nan, -1e9).holds());
  EXPECT_FALSE(Claim::told("", "", nan, 1).holds());
}

}  // namespace
}  // namespace sabo
