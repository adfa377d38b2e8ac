#include "base/describe.hpp"

#include <array>
#include <limits>

#include <gtest/gtest.h>

namespace sabo {

enum class Colour { red, green };
template <>
struct Words<Colour> {
  static constexpr std::array<std::string_view, 2> list{"red", "green"};
};

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

struct Plain {
  double x = 0;
};
struct WithDescription {
  double x = 0;
  template <class V>
  void describe(V&& v) {
    v(Key{"x", "m", "a length"}, x);
  }
};

TEST(Key, TakesEveryNumberWithoutARange) {
  constexpr Key key{"x", "", ""};
  EXPECT_TRUE(key.accepts(-1e300));
  EXPECT_TRUE(key.accepts(infinity));
  EXPECT_FALSE(key.accepts(nan));
}

TEST(Key, AClosedRangeHasItsEnds) {
  constexpr Key key = Key{"x", "", ""}.at_least(0).at_most(60);
  EXPECT_TRUE(key.accepts(0));
  EXPECT_TRUE(key.accepts(60));
  EXPECT_FALSE(key.accepts(-1e-9));
  EXPECT_FALSE(key.accepts(60.001));
  EXPECT_FALSE(key.accepts(nan));
}

TEST(Key, AnOpenRangeLacksItsLowerEnd) {
  constexpr Key key = Key{"x", "", ""}.above(0);
  EXPECT_FALSE(key.accepts(0));
  EXPECT_TRUE(key.accepts(std::numeric_limits<double>::denorm_min()));
  EXPECT_FALSE(key.accepts(nan));
}

TEST(Key, IsOptionalUnlessItSaysSo) {
  EXPECT_FALSE((Key{"x", "", ""}.at_least(0).is_required));
  EXPECT_TRUE((Key{"x", "", ""}.above(0).required().is_required));
}

TEST(Words, NameTheValues) {
  EXPECT_EQ(word_of(Colour::red), "red");
  EXPECT_EQ(word_of(Colour::green), "green");
}

TEST(Described, TellsStructsApart) {
  EXPECT_TRUE(Described<WithDescription>);
  EXPECT_FALSE(Described<Plain>);
  EXPECT_FALSE(Described<double>);
}

}  // namespace
}  // namespace sabo
