#include "base/faults.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sabo {
namespace {

TEST(NearestWord, FindsASlip) {
  EXPECT_EQ(nearest_word("spacin", {"method", "spacing", "cfl"}), "spacing");
  EXPECT_EQ(nearest_word("visocsity", {"density", "viscosity"}), "viscosity");
}

TEST(NearestWord, TakesTheNearerOfTwo) {
  EXPECT_EQ(nearest_word("crest_", {"rest", "crest"}), "crest");
}

TEST(NearestWord, SuggestsNothingFarAway) {
  EXPECT_EQ(nearest_word("temperature", {"spacing", "method"}), "");
  EXPECT_EQ(nearest_word("abcd", {"xbcyz"}), "");  // three edits of four letters
  EXPECT_EQ(nearest_word("anything", {}), "");
}

TEST(NearestWord, TakesEmptyWords) {
  EXPECT_EQ(nearest_word("", {"abc"}), "");  // three letters away
  EXPECT_EQ(nearest_word("", {"ab"}), "ab");
}

TEST(Faults, PlaceOfAKnownKey) {
  Faults faults;
  faults.remember("numerics.spacing", "case.toml:12");
  faults.add("numerics.spacing", "is missing", "give a number");
  EXPECT_EQ(to_string(faults.list().at(0)),
            "case.toml:12 numerics.spacing: is missing; give a number");
}

TEST(Faults, PlaceFallsBackToTheEnclosingTableThenToTheFile) {
  Faults faults;
  faults.remember("", "case.toml");
  faults.remember("structure[2]", "case.toml:30");
  faults.add("structure[2].notch.width", "a");
  faults.add("structure[1].line", "b");
  faults.add("", "c");
  EXPECT_EQ(faults.list().at(0).place, "case.toml:30 structure[2].notch.width");
  EXPECT_EQ(faults.list().at(1).place, "case.toml structure[1].line");
  EXPECT_EQ(faults.list().at(2).place, "case.toml");
}

TEST(Faults, AKeyAloneIsItsOwnPlace) {
  Faults faults;
  faults.add("terrain.dem", "cannot be read");
  EXPECT_EQ(to_string(faults.list().at(0)), "terrain.dem: cannot be read");
}

TEST(Faults, KnowWhichKeysHaveOne) {
  Faults faults;
  EXPECT_TRUE(faults.empty());
  faults.add("release.volume", "a");
  EXPECT_TRUE(faults.has("release.volume"));
  EXPECT_FALSE(faults.has("release"));
  EXPECT_FALSE(faults.empty());
}

TEST(Faults, ThrowAllTogether) {
  Faults faults;
  EXPECT_NO_THROW(faults.throw_if_any());
  faults.add("a", "one");
  faults.add("b", "two");
  try {
    faults.throw_if_any();
    FAIL() << "nothing was thrown";
  } catch (const CaseError& error) {
    EXPECT_EQ(error.faults().size(), 2u);
    EXPECT_STREQ(error.what(), "a: one\nb: two");
  }
}

TEST(CaseError, CarriesOneFault) {
  const CaseError error("dem.tif", "has no CRS", "set assume_metres = true");
  EXPECT_STREQ(error.what(), "dem.tif: has no CRS; set assume_metres = true");
  EXPECT_EQ(error.faults().size(), 1u);
}

}  // namespace
}  // namespace sabo
