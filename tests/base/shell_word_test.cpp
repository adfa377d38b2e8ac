#include "base/shell_word.hpp"

#include <gtest/gtest.h>

namespace sabo {
namespace {

TEST(ShellWord, IsQuotedWhereAShellWouldTakeItForMore) {
  EXPECT_EQ(shell_word("runs/yohutagawa-1.5"), "runs/yohutagawa-1.5");
  EXPECT_EQ(shell_word("沢"), "沢");
  EXPECT_EQ(shell_word("my case"), "'my case'");
  EXPECT_EQ(shell_word("a;b$c"), "'a;b$c'");
  EXPECT_EQ(shell_word("it's"), R"('it'\''s')");
  EXPECT_EQ(shell_word(""), "''");
}

}  // namespace
}  // namespace sabo
