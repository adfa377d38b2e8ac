#include "io/case_file/text_check.hpp"

#include "case_file/support.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sabo {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(TextCheck, TakesUnicodeTabsAndBothLineEnds) {
  EXPECT_FALSE(find_unfit_text("a\tb\r\nc\n# \u00e9 \u4e0e \U0001F30B"));
  EXPECT_FALSE(find_unfit_text(""));
  EXPECT_FALSE(find_unfit_text("\n\n"));
}

TEST(TextCheck, ControlCharacters) {
  EXPECT_THAT(messages("\n[\x1a"), ElementsAre("case.toml:2: control character 0x1a; remove it"));
  EXPECT_TRUE(find_unfit_text(std::string_view("a\0b", 3)));
  EXPECT_TRUE(find_unfit_text("a\rb"));
  EXPECT_TRUE(find_unfit_text("\x7f"));
}

TEST(TextCheck, BytesThatAreNotUtf8) {
  EXPECT_THAT(messages("title = \"\xe9\""),
              ElementsAre("case.toml:1: byte 0xe9 is not UTF-8; save the file as UTF-8"));
  EXPECT_TRUE(find_unfit_text("\x80"));              // continuation without a lead
  EXPECT_TRUE(find_unfit_text("\xc0\xaf"));          // overlong
  EXPECT_TRUE(find_unfit_text("\xe0\x80\xaf"));      // overlong
  EXPECT_TRUE(find_unfit_text("\xed\xa0\x80"));      // surrogate
  EXPECT_TRUE(find_unfit_text("\xf4\x90\x80\x80"));  // above U+10FFFF
  EXPECT_TRUE(find_unfit_text("\xf0\x9f\x8c"));      // cut short
}

TEST(TextCheck, TextWithoutStraightQuotes) {
  for (const char* name : {"\u201cdem.tif\u201d", "`dem.tif`", "dem.tif"}) {
    EXPECT_THAT(messages("\n[terrain]\ndem = " + std::string(name)),
                ElementsAre("case.toml:3: not valid TOML: error while parsing value: could not "
                            "determine value type; write text in straight quotes, \"like this\""));
  }
  EXPECT_THAT(messages("d\u00e9m = 1"),
              ElementsAre("case.toml:1: not valid TOML: error while parsing key-value pair: "
                          "expected '=', saw a character that may stand in quotes only; "
                          "write text in straight quotes, \"like this\""));
  // toml++ does not stand these.
  EXPECT_THAT(messages("a = [[0,\u0422]]"), ElementsAre(HasSubstr("case.toml:1: not valid TOML")));
  EXPECT_THAT(messages("a = 0X=[[\"\u0444\""), ElementsAre(HasSubstr("case.toml:1: not valid")));
}

TEST(TextCheck, CharactersInQuotesAndComments) {
  const auto title = [](const std::string& line) {
    Faults faults;
    return read_case_text(line, folder_with_files(), faults).title;
  };
  EXPECT_EQ(title("title = \"\u00e9 \u6ca2 \U0001F30B ` `e9\" # \u00e9"),
            "\u00e9 \u6ca2 \U0001F30B ` `e9");
  EXPECT_EQ(title("title = '\u00e9'"), "\u00e9");
  EXPECT_EQ(title("title = \"\\u00e9\""), "\u00e9");
  EXPECT_EQ(title("title = \"\\u0060e9\""), "`e9");
  EXPECT_EQ(title("title = \"\\u0060e\""), "`e");
  EXPECT_EQ(title("title = \"\\u0060\""), "`");
  EXPECT_EQ(title("\xEF\xBB\xBFtitle = \"a\""), "a");  // byte order mark
}

TEST(TextCheck, Size) {
  EXPECT_FALSE(find_unfit_text(std::string(1'000'000, ' ')));
  EXPECT_THAT(messages(std::string(1'000'001, ' ')),
              ElementsAre("case.toml: larger than 1 MB; "
                          "give long lines as vector files, not as coordinates"));
}

TEST(TextCheck, LargeFilesAreNotReadWhole) {
  const TemporaryFolder folder;
  const auto file = folder.write("big.toml", std::string(3'000'000, '\n'));
  Faults faults;
  read_case(file, faults);
  ASSERT_EQ(faults.list().size(), 1u);
  EXPECT_THAT(to_string(faults.list()[0]), HasSubstr("big.toml: larger than 1 MB"));
}

TEST(TextCheck, DeepKeys) {
  std::string deep = "a";
  for (int i = 0; i < 200'000; ++i) deep += ".a";
  EXPECT_THAT(messages("[" + deep + "]"),
              ElementsAre("case.toml:1: more than 200 dots in one line; shorten the line"));
  std::string digits = "1";
  for (int i = 0; i < 300; ++i) digits += ".1";
  EXPECT_TRUE(find_unfit_text(digits));
  std::string coordinates = "line = [[1.5, 2.5]";
  for (int i = 0; i < 1000; ++i) coordinates += ", [100.25, 200.5]";
  EXPECT_FALSE(find_unfit_text(coordinates));
}

TEST(TextCheck, DeepNesting) {
  EXPECT_THAT(messages("a = " + std::string(1000, '[')),
              ElementsAre(HasSubstr("case.toml:1: not valid TOML: error while parsing")));
}

}  // namespace
}  // namespace sabo
