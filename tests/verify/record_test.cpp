#include "verify/record.hpp"

#include <cmath>
#include <fstream>

#include "support/temporary_folder.hpp"
#include "verify/report.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"

namespace sabo {
namespace {

using testing::HasSubstr;

/// Named as a case is, for the report looks up its title.
VerifyRecord made_record() {
  VerifyRecord record{"slab", Method::paper, Effort::quick};
  record.verdict.claims = {Claim::within_share("speed \"x\"", "m/s", 2.42, 2.353, 0.05),
                           Claim::within("front", "m", 12, 10, 1.5),
                           Claim::at_most("ratio", "", std::nan(""), 1.5)};
  record.verdict.charts = {{"Title", "x", "y", {{"a", {0, 1}, {0, 1}}}}};
  record.verdict.remarks = {"of a µ & <b>"};
  record.seconds = 12.5;
  record.date = "2026-01-02T03:04:05Z";
  return record;
}

TEST(VerifyRecord, IsReadBackAsItWasWritten) {
  const TemporaryFolder folder;
  VerifyRecord written = made_record();
  write_record(written, folder / "new");
  ASSERT_THAT(written.pictures, testing::ElementsAre("slab-paper-quick-1.svg"));
  const auto read = read_record(folder / "new", "slab", Method::paper, Effort::quick);
  ASSERT_TRUE(read);
  ASSERT_EQ(read->verdict.claims.size(), 3u);
  EXPECT_EQ(read->verdict.claims[0].what, "speed \"x\"");
  EXPECT_EQ(read->verdict.claims[0].measured, 2.42);
  EXPECT_EQ(read->verdict.claims[1].margin, 1.5);
  EXPECT_EQ(read->verdict.claims[1].gate, GateKind::within);
  EXPECT_TRUE(std::isnan(read->verdict.claims[2].measured));
  EXPECT_EQ(read->verdict.remarks, written.verdict.remarks);
  EXPECT_EQ(read->pictures, written.pictures);
  EXPECT_EQ(read->date, written.date);
  EXPECT_EQ(read->seconds, 12.5);
  EXPECT_FALSE(read->holds());
  EXPECT_FALSE(read_record(folder / "new", "slab", Method::fast, Effort::quick));
  EXPECT_FALSE(read_record(folder / "new", "slab", Method::paper, Effort::full));
}

TEST(VerifyRecord, OfAnotherProgramOrDamagedIsNoRecord) {
  const TemporaryFolder folder;
  for (const char* text : {"program = \"00000000\"\n", "version = ", "", "claim = 3"}) {
    folder.write("slab-fast-full.toml", text);
    EXPECT_FALSE(read_record(folder / "", "slab", Method::fast, Effort::full)) << text;
  }
}

TEST(VerifyRecord, KeepsWhyACaseFailed) {
  const Verification failing{"slab", "", "", {Method::fast}, [](const VerifySettings&) -> Verdict {
                               throw RunError("it blew up");
                             }};
  const VerifyRecord record = run_verification(failing, {});
  EXPECT_EQ(record.failure, "it blew up");
  EXPECT_FALSE(record.holds());
  EXPECT_THAT(text_of(record), HasSubstr("FAIL  slab (fast)"));
  EXPECT_THAT(text_of(record), HasSubstr("it blew up"));
}

TEST(VerifyRecord, WithoutClaimsDoesNotPass) { EXPECT_FALSE(VerifyRecord{}.holds()); }

TEST(VerifyReport, SaysMeasuredGateAndOutcomeOfEachClaim) {
  const std::string text = text_of(made_record());
  EXPECT_THAT(text, HasSubstr("pass  speed \"x\"  2.42 m/s  within 5 % of 2.353 m/s"));
  EXPECT_THAT(text, HasSubstr("FAIL  front      12 m      within 1.5 m of 10 m"));
  EXPECT_THAT(text, HasSubstr("FAIL  ratio"));
  const std::string json = json_of({made_record()});
  EXPECT_THAT(json, HasSubstr(R"("what": "speed \"x\"")"));
  EXPECT_THAT(json, HasSubstr(R"("measured": null)"));
}

TEST(VerifyReport, EscapesTextOnItsPage) {
  const TemporaryFolder folder;
  write_verify_page({made_record()}, folder / "");
  EXPECT_THAT(folder.read("index.html"), HasSubstr("&lt;b&gt;"));
}

}  // namespace
}  // namespace sabo
