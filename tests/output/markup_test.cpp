#include <gtest/gtest.h>
// rapidcheck needs gtest before it
#include <cmath>
#include <string>

#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "io/output/markup.hpp"
#include "io/output/ticks.hpp"

namespace sabo {
namespace {

TEST(Escaped, LeavesNoMarkup) {
  EXPECT_EQ(escaped("a < b & \"c\" > 'd'"), "a &lt; b &amp; &quot;c&quot; &gt; &#39;d&#39;");
  EXPECT_EQ(escaped("m³/s ü 沢 𝄞"), "m³/s ü 沢 𝄞");
}

TEST(Escaped, ReplacesWhatXmlCannotHold) {
  const std::string mark = "\uFFFD";
  EXPECT_EQ(escaped(std::string("a\0b\x1b", 4)), "a" + mark + "b" + mark);
  EXPECT_EQ(escaped("\xFF|\xC0\xAF|\xE2\x82"), mark + "|" + mark + mark + "|" + mark + mark);
  EXPECT_EQ(escaped("\xED\xA0\x80"), mark + mark + mark);  // half of a surrogate pair
}

RC_GTEST_PROP(EscapedLaw, AnyBytesBecomeSafe, (const std::string& bytes)) {
  const std::string safe = escaped(bytes);
  RC_ASSERT(safe.find_first_of("<>\"'") == std::string::npos);
  RC_ASSERT(safe.find('\0') == std::string::npos);
}

TEST(UrlOf, EncodesAllButPlainCharacters) {
  EXPECT_EQ(url_of("maps/a b#1.tif"), "maps/a%20b%231.tif");
  EXPECT_EQ(url_of("é"), "%C3%A9");
}

TEST(RoundDown, TakesOneTwoOrFive) {
  EXPECT_DOUBLE_EQ(round_down(9.99), 5);
  EXPECT_DOUBLE_EQ(round_down(5), 5);
  EXPECT_DOUBLE_EQ(round_down(0.3), 0.2);
  EXPECT_DOUBLE_EQ(round_down(199), 100);
  EXPECT_DOUBLE_EQ(round_down(1000), 1000);
}

TEST(Ticks, AreRoundAndHoldTheData) {
  const Ticks ticks = ticks_over(0, 363, 5);
  EXPECT_EQ(ticks.values, (std::vector<double>{0, 100, 200, 300, 400}));
  EXPECT_EQ(ticks.label(400), "400");
  const Ticks small = ticks_over(-0.1, 0.32, 4);
  EXPECT_DOUBLE_EQ(small.step, 0.1);
  EXPECT_EQ(small.label(small.first()), "\u22120.1");
  EXPECT_EQ(small.label(-1e-18), "0.0");
}

RC_GTEST_PROP(TicksLaw, AnyFiniteRangeGetsAFewTicks, (double low, double high)) {
  RC_PRE(std::abs(low) < 1e100 && std::abs(high) < 1e100);
  const Ticks ticks = ticks_over(low, high, 5);
  RC_ASSERT(ticks.values.size() >= 2u && ticks.values.size() <= 15u);
  RC_ASSERT(ticks.first() <= std::min(low, high) + 1e-6 * ticks.step);
  RC_ASSERT(ticks.last() >= std::max(low, high) - 1e-6 * ticks.step);
}

}  // namespace
}  // namespace sabo
