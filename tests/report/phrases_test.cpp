#include "report/phrases.hpp"

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

#include "support/folders.hpp"
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "physics/rheology_list.hpp"

namespace sabo {
namespace {

std::set<std::string> places_of(const std::string& text) {
  std::set<std::string> places;
  for (std::size_t from = text.find('{'); from != text.npos; from = text.find('{', from + 1))
    places.insert(text.substr(from, text.find('}', from) + 1 - from));
  return places;
}

/// Everything in quotes in the sources of the report.
std::set<std::string> literals_of_sources() {
  std::set<std::string> literals;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(repository() / "src" / "report")) {
    if (entry.path().extension() != ".cpp") continue;
    std::ostringstream stream;
    stream << std::ifstream(entry.path()).rdbuf();
    const std::string text = stream.str();
    std::size_t to = 0;
    for (std::size_t from = text.find('"'); from != text.npos; from = to) {
      to = text.find('"', from + 1);
      literals.insert(text.substr(from + 1, to == text.npos ? to : to - from - 1));
    }
  }
  return literals;
}

/// Tables that are read as lists, or whose keys are names of a run.
bool is_listed(const std::string& key) {
  for (const char* table : {"not_modelled.", "validity.", "key.", "map.", "quantity."})
    if (key.starts_with(table)) return true;
  return false;
}

TEST(Phrases, BothLanguagesHaveTheSameKeysInTheSameOrder) {
  EXPECT_EQ(Phrases(Language::en).keys(), Phrases(Language::ja).keys());
  EXPECT_GT(Phrases(Language::en).keys().size(), 200u);
}

TEST(Phrases, BothLanguagesHaveTheSamePlaces) {
  const Phrases english(Language::en), japanese(Language::ja);
  for (const std::string& key : english.keys()) {
    EXPECT_EQ(places_of(english.text(key)), places_of(japanese.text(key))) << key;
    EXPECT_NE(japanese.text(key), "") << key;
  }
}

TEST(Phrases, EveryTextIsUsed) {
  const std::set<std::string> literals = literals_of_sources();
  for (const std::string& key : Phrases(Language::en).keys())
    EXPECT_TRUE(is_listed(key) || literals.contains(key)) << key;
}

TEST(Phrases, PutsArgumentsInTheirPlaces) {
  const Phrases phrases(Language::en);
  EXPECT_EQ(phrases("summary.arrival", "the {dam}", "3.5"),
            "It arrived at “the {dam}” after 3.5 s. ");
  EXPECT_THROW(phrases("summary.nothing"), RunError);
  EXPECT_THROW(phrases("summary"), RunError);
}

TEST(Phrases, EveryLawHasItsSource) {
  for (const Rheology& law : all_rheologies())
    EXPECT_NE(source_of_law(name_of(law)), "") << name_of(law);
  EXPECT_EQ(source_of_law("no such law"), "");
}

}  // namespace
}  // namespace sabo
