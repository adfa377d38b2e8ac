#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "io/case_file/read_hazard_rules.hpp"

namespace sabo {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> rule_faults(const std::string& text) {
  Faults faults;
  read_hazard_rules(text, "my.toml", faults);
  std::vector<std::string> lines;
  for (const Fault& fault : faults.list()) lines.push_back(to_string(fault));
  return lines;
}

HazardRules known(const char* name) {
  Faults faults;
  HazardRules rules = read_hazard_rules(hazard_rules_text(name), name, faults);
  for (const Fault& fault : faults.list()) ADD_FAILURE() << to_string(fault);
  return rules;
}

const std::string smallest = R"(name = "mine"
source = "me"
[[class]]
name = "wet"
colour = "#102030"
)";

TEST(HazardRulesFile, ThoseOfTheProgramAreSoundAndSayWhereTheyAreFrom) {
  for (const std::string& name : known_hazard_rules()) {
    const HazardRules rules = known(name.c_str());
    EXPECT_FALSE(rules.source.empty()) << name;
    EXPECT_FALSE(rules.caution.empty()) << name;
    EXPECT_TRUE(rules.classes.back().when.empty()) << name << ": what is left of the wet cells";
  }
  EXPECT_EQ(hazard_rules_text("swiss_"), "");
}

TEST(HazardRulesFile, SwissClassesAndMatrix) {
  const HazardRules rules = known("swiss");
  ASSERT_EQ(rules.classes.size(), 2u);
  ASSERT_EQ(rules.classes[0].when.size(), 1u);
  ASSERT_EQ(rules.classes[0].when[0].size(), 2u);
  EXPECT_EQ(rules.classes[0].when[0][0].quantity, HazardQuantity::depth);
  EXPECT_EQ(rules.classes[0].when[0][0].above, 1);
  EXPECT_EQ(rules.classes[0].when[0][1].quantity, HazardQuantity::speed);
  EXPECT_EQ(rules.classes[0].when[0][1].above, 1);
  ASSERT_TRUE(rules.matrix);
  EXPECT_THAT(rules.matrix->return_periods, ElementsAre(30, 100, 300));
  EXPECT_THAT(rules.matrix->levels[0], ElementsAre(0, 0, 0)) << "strong is red throughout";
}

TEST(HazardRulesFile, JapaneseHouse) {
  const HazardRules rules = known("japan");
  ASSERT_TRUE(rules.house);
  EXPECT_EQ(rules.house->a, 35.3);
  EXPECT_EQ(rules.house->b, 5.6);
}

TEST(HazardRulesFile, FaultsHaveALineAndARemedy) {
  EXPECT_THAT(rule_faults(smallest), IsEmpty());
  EXPECT_THAT(rule_faults(smallest + "colur = \"#000000\"\n"),
              ElementsAre("my.toml:6 class[1].colur: unknown key; did you mean \"colour\"?"));
  EXPECT_THAT(rule_faults("name = 1\nsource = \"x\"\n"),
              testing::Contains(HasSubstr("my.toml:1 name: is not a text")));
  EXPECT_THAT(rule_faults(smallest + "when = [{ dept = 1 }]\n"),
              ElementsAre(HasSubstr("my.toml:6 class[1].when: \"dept\" is not known; use one of: "
                                    "depth, deposit")));
  EXPECT_THAT(rule_faults(smallest + "when = [{ depth = -1 }]\n"),
              ElementsAre(HasSubstr("the threshold of depth is not a number in range")));
  EXPECT_THAT(rule_faults(smallest + "when = []\n"), ElementsAre(HasSubstr("list of conditions")));
  EXPECT_THAT(rule_faults(smallest + "when = [{}]\n"), ElementsAre(HasSubstr("empty condition")));
  EXPECT_THAT(rule_faults(smallest + "when = [{ impact_over_house = 1 }]\n"),
              ElementsAre(HasSubstr("house: is missing")));
  EXPECT_THAT(rule_faults(smallest + "[[class]]\nname = \"wet\"\ncolour = \"red\"\n"),
              ElementsAre(HasSubstr("class[2].colour: is not a colour"),
                          HasSubstr("class[2].name: \"wet\" is there twice")));
  EXPECT_THAT(rule_faults("name = \"a\"\nsource = \"b\"\n"),
              ElementsAre(HasSubstr("class: is missing")));
}

TEST(HazardRulesFile, AMatrixHasALevelForEachClassAndPeriod) {
  const std::string levels = smallest + "[[level]]\nname = \"red\"\ncolour = \"#ff0000\"\n";
  EXPECT_THAT(
      rule_faults(levels + "[matrix]\nreturn_periods = [30, 100]\nwet = [\"red\", \"red\"]\n"),
      IsEmpty());
  EXPECT_THAT(rule_faults(levels + "[matrix]\nreturn_periods = [30, 100]\nwet = [\"red\"]\n"),
              ElementsAre(HasSubstr("matrix.wet: has not one level for each return period")));
  EXPECT_THAT(rule_faults(levels + "[matrix]\nreturn_periods = [30]\n"),
              ElementsAre(HasSubstr("matrix.wet: is missing")));
  EXPECT_THAT(rule_faults(levels + "[matrix]\nreturn_periods = [30]\nwet = [\"rde\"]\n"),
              ElementsAre(HasSubstr("\"rde\" is no level; use one of: red")));
  EXPECT_THAT(rule_faults(levels + "[matrix]\nreturn_periods = [30, 20]\nwet = [\"red\"]\n"),
              ElementsAre(HasSubstr("return_periods: do not rise")));
}

TEST(HazardRulesFile, DamagedTextsGiveFaultsAndNothingElse) {
  EXPECT_TRUE(rc::check("a text with some bytes changed is read or refused", [] {
    const std::vector<std::string> names = known_hazard_rules();
    std::string text(hazard_rules_text(*rc::gen::elementOf(names)));
    for (int k = 0; k < 4; ++k) {
      const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
      text[at] = *rc::gen::elementOf(std::string("[]{}=\"#,.1a\n"));
    }
    Faults faults;
    const HazardRules rules = read_hazard_rules(text, "damaged", faults);
    if (faults.empty()) RC_ASSERT(!rules.classes.empty());
  }));
}

}  // namespace
}  // namespace sabo
