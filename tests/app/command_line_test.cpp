#include "support/temporary_folder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/program.hpp"

namespace sabo {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;
using testing::StartsWith;

TEST(CommandLine, SaysItsVersion) {
  const Outcome outcome = run_shell("sabo --version");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.text, StartsWith("sabo 0."));
}

TEST(CommandLine, WithoutACommandIsAUsageErrorThatHelps) {
  const Outcome outcome = run_shell("sabo");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.text, HasSubstr("sabo run demo"));
}

TEST(CommandLine, HelpIsNoError) {
  for (const char* command : {"", "new", "check", "run", "study", "plot", "report", "compare",
                              "hazard", "export", "info", "models", "bench"}) {
    const Outcome outcome = run_shell(std::string("sabo ") + command + " --help");
    EXPECT_EQ(outcome.code, 0) << command;
    EXPECT_THAT(outcome.text, HasSubstr("Usage: sabo")) << command;
  }
}

TEST(CommandLine, OptionsTakeTheirHelpFromTheKeysOfTheCase) {
  const Outcome outcome = run_shell("sabo run --help");
  EXPECT_THAT(outcome.text, HasSubstr("--spacing M                 initial distance of particles"));
  EXPECT_THAT(outcome.text, HasSubstr("--backend reference|cpu"));
}

TEST(CommandLine, SuggestsTheNearestCommandOptionAndTemplate) {
  const Outcome command = run_shell("sabo chekc demo");
  EXPECT_EQ(command.code, 2);
  EXPECT_EQ(command.text, "error: there is no command \"chekc\"; did you mean \"check\"?\n");

  const Outcome option = run_shell("sabo run demo --spacng=1");
  EXPECT_EQ(option.code, 2);
  EXPECT_EQ(option.text, "error: run has no option --spacng; did you mean \"--spacing\"?\n");

  const Outcome name = run_shell("sabo new yohutagwa /nowhere/demo");
  EXPECT_EQ(name.code, 2);
  EXPECT_EQ(name.text, "error: there is no template \"yohutagwa\"; did you mean \"yohutagawa\"?\n");
}

TEST(CommandLine, AReportNeedsARunAndAKnownLanguage) {
  const Outcome folder = run_shell("sabo report /nowhere");
  EXPECT_EQ(folder.code, 2);
  EXPECT_THAT(folder.text, HasSubstr("/nowhere: is not the folder of a run"));

  const Outcome language = run_shell("sabo report /nowhere --language de");
  EXPECT_EQ(language.code, 2);
  EXPECT_THAT(language.text, HasSubstr("de"));
}

TEST(CommandLine, MissingArgumentsAreUsageErrors) {
  for (const char* command : {"sabo new", "sabo check", "sabo run", "sabo info", "sabo report",
                              "sabo run x -o", "sabo study x"})
    EXPECT_EQ(run_shell(command).code, 2) << command;
}

TEST(CommandLine, ModelsAndDefaultsNeedNoCase) {
  const Outcome models = run_shell("sabo models");
  EXPECT_EQ(models.code, 0);
  EXPECT_THAT(models.text, HasSubstr("rheology = \"cross\""));
  const Outcome defaults = run_shell("sabo check --defaults");
  EXPECT_EQ(defaults.code, 0);
  EXPECT_THAT(defaults.text, HasSubstr("h_over_dp = 1.5"));
}

TEST(CommandLine, DrawsTheLawsThatAreNamed) {
  const TemporaryFolder folder;
  const std::string draw = "sabo models --plot -o '" + (folder / "").string() + "' ";
  EXPECT_EQ(run_shell(draw + "--laws bingham,mu_i --pressure 1000").code, 0);
  const std::string svg = folder.read("effective_viscosity.svg");
  EXPECT_THAT(svg, HasSubstr(">mu_i</text>"));
  EXPECT_THAT(svg, HasSubstr("plastic viscosity 20 Pa s, yield stress 50 Pa"));
  EXPECT_THAT(folder.read("shear_stress.svg"), HasSubstr(">bingham</text>"));

  const Outcome unknown = run_shell(draw + "--laws binham");
  EXPECT_EQ(unknown.code, 2);
  EXPECT_EQ(unknown.text, "error: --laws: there is no law \"binham\"; did you mean \"bingham\"?\n");
  EXPECT_EQ(run_shell("sabo models --plot -o /nowhere").code, 2);
  EXPECT_EQ(run_shell(draw + "--viscosity 0").code, 2);
}

TEST(CommandLine, ListsAllFaultsOfACaseWithoutColours) {
  const TemporaryFolder folder;
  folder.write("case.toml", "[run]\nduration = -1\n[numerics]\nspcing = 1\n");
  const Outcome outcome = run_shell("sabo check '" + (folder / "").string() + "' --spacing abc");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.text, MatchesRegex("[0-9]+ faults in [^\n]*:\n(  [^\n]+\n)+"));
  EXPECT_THAT(outcome.text, HasSubstr("\n  case.toml:2 run.duration: "));
  EXPECT_THAT(outcome.text, HasSubstr("did you mean \"spacing\"?"));
  EXPECT_THAT(outcome.text, HasSubstr("\n  command line numerics.spacing: found the text \"abc\""));
  EXPECT_THAT(outcome.text, Not(HasSubstr("\x1b")));
}

TEST(CommandLine, FailsWhenItsOutputCannotBeWritten) {
  const Outcome outcome = run_shell("sabo models > /dev/full");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(outcome.text, "error: cannot write to the standard output\n");
}

TEST(CommandLine, RefusesAFolderThatIsNoRun) {
  const TemporaryFolder folder;
  for (const char* command : {"sabo info '", "sabo plot '"}) {
    const Outcome outcome = run_shell(command + (folder / "").string() + "'");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.text, HasSubstr("is not the folder of a run"));
  }
}

}  // namespace
}  // namespace sabo
