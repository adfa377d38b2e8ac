#include "support/temporary_folder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/program.hpp"

namespace sabo {
namespace {

using testing::HasSubstr;

TEST(VerifyCommand, ListsItsCases) {
  const Outcome list = run_shell("sabo verify");
  EXPECT_EQ(list.code, 0);
  EXPECT_THAT(list.text, HasSubstr("slab"));
  EXPECT_THAT(list.text, HasSubstr("(fast, paper)"));
}

TEST(VerifyCommand, LeavesPageJsonAndPictures) {
  const TemporaryFolder folder;
  const std::string at = (folder / "out").string();
  const Outcome run =
      run_shell("sabo verify slab --quick --threads 1 --method fast -o '" + at + "'");
  ASSERT_EQ(run.code, 0) << run.text;
  EXPECT_THAT(run.text, HasSubstr("pass  slab (fast)"));
  EXPECT_THAT(run.text, HasSubstr("1 of 1 cases pass"));
  EXPECT_THAT(folder.read("out/index.html"), HasSubstr("slab-fast-quick-1.svg"));
  EXPECT_THAT(folder.read("out/slab-fast-quick-1.svg"), HasSubstr("</svg>"));
  const Outcome json = run_shell("python3 -m json.tool '" + at + "/verify.json'");
  EXPECT_EQ(json.code, 0) << json.text;
}

TEST(VerifyCommand, TellsOfAFolderThatItCannotMakeBeforeItRuns) {
  const TemporaryFolder folder;
  folder.write("file", "");
  const Outcome run =
      run_shell("sabo verify hydrostatic -o '" + (folder / "file/out").string() + "'");
  EXPECT_NE(run.code, 0);
  EXPECT_THAT(run.text, HasSubstr("cannot make "));
}

TEST(VerifyCommand, RefusesWhatDoesNotExist) {
  const Outcome name = run_shell("sabo verify slap");
  EXPECT_EQ(name.code, 2);
  EXPECT_THAT(name.text, HasSubstr("there is no case \"slap\"; give some of "));
  EXPECT_THAT(name.text, HasSubstr("slab"));
  const Outcome method = run_shell("sabo verify slab --method quick");
  EXPECT_EQ(method.code, 2);
  EXPECT_THAT(method.text, HasSubstr("there is no method \"quick\"; give fast or paper"));
  const Outcome none = run_shell("sabo verify runout --method paper");
  EXPECT_EQ(none.code, 2);
  EXPECT_THAT(none.text, HasSubstr("none of these cases is for that method"));
}

}  // namespace
}  // namespace sabo
