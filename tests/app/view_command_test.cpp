#include "support/temporary_folder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/program.hpp"

namespace sabo {
namespace {

using testing::HasSubstr;

TEST(ViewCommand, SaysWhatIsNoRun) {
  const TemporaryFolder folder;
  const Outcome view = run_shell("sabo view '" + (folder / "").string() + "' --no-browser");
  EXPECT_EQ(view.code, 2);
  EXPECT_THAT(view.text, HasSubstr("is not the folder of a run"));
  EXPECT_THAT(view.text, HasSubstr("give a folder that `sabo run` has written"));
}

TEST(ViewCommand, RefusesAPortThatIsNone) {
  EXPECT_EQ(run_shell("sabo view x --port 70000").code, 2);
  EXPECT_EQ(run_shell("sabo view x --port 0").code, 2);
}

TEST(ViewCommand, ServesUntilItIsStopped) {
  const TemporaryFolder folder;
  const Outcome view = run_shell(
      "cd '" + (folder / "").string() +
      "' && sabo new yohutagawa demo >new.log && sabo run demo --spacing 4 --duration 0.1 >run.log"
      " && { '" SABO_PROGRAM
      "' view demo-run --no-browser >view.log & server=$!; }"
      " && while kill -0 $server && ! grep -q http view.log; do sleep 0.05; done"
      " && kill -0 $server && kill $server; cat view.log");
  EXPECT_EQ(view.code, 0);
  EXPECT_THAT(view.text, HasSubstr("http://127.0.0.1:"));
}

}  // namespace
}  // namespace sabo
