#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/program.hpp"

namespace sabo {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

TEST(PostCommands, PrintRulesThatCanBeUsedAgain) {
  const Outcome outcome = run_shell("sabo hazard --rules japan");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.text, AllOf(StartsWith("# "), HasSubstr("\na = 35.3\n")));
}

TEST(PostCommands, EndWithTwoWhereTheInputIsWrong) {
  for (const char* command :
       {"sabo compare /nowhere /nowhere", "sabo compare /nowhere --observed a.tif",
        "sabo hazard /nowhere", "sabo hazard --rules none", "sabo export /nowhere"}) {
    const Outcome outcome = run_shell(command);
    EXPECT_EQ(outcome.code, 2) << command;
    EXPECT_THAT(outcome.text, StartsWith("error: ")) << command;
  }
}

TEST(PostCommands, ARunIsComparedWithOneThingAtATime) {
  const Outcome outcome = run_shell("sabo compare a b --wet 0.2");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.text, HasSubstr("a run is compared with a run or with a survey"));
}

}  // namespace
}  // namespace sabo
