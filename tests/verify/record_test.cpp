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
  record.version = "0.1.0+gabc";
  record.machine = "An & B";
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
  EXPECT_EQ(read->version, written.version);
  EXPECT_EQ(read->machine, written.machine);
  EXPECT_FALSE(read->holds());
  EXPECT_FALSE(read_record(folder / "new", "slab", Method::fast, Effort::quick));
  EXPECT_FALSE(read_record(folder / "new", "slab", Method::paper, Effort::full));
}

TEST(VerifyRecord, SaysWhetherThisProgramMadeIt) {
  const TemporaryFolder folder;
  VerifyRecord record = made_record();
  for (const bool is_current : {true, false}) {
    record.is_current = is_current;
    write_record(record, folder / "");
    const auto read = read_record(folder / "", "slab", Method::paper, Effort::quick);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->is_current, is_current);
  }
}

TEST(VerifyRecord, DamagedIsNoRecord) {
  const TemporaryFolder folder;
  for (const char* text : {"program = \"00000000\"\n", "version = ", "", "claim = 3"}) {
    folder.write("slab-fast-full.toml", text);
    EXPECT_FALSE(read_record(folder / "", "slab", Method::fast, Effort::full)) << text;
  }
}

TEST(VerifyRecord, LeavesNoPicturesOfAnEarlierRun) {
  const TemporaryFolder folder;
  VerifyRecord record = made_record();
  record.verdict.charts.resize(3, record.verdict.charts[0]);
  write_record(record, folder / "");
  ASSERT_TRUE(std::filesystem::exists(folder / "slab-paper-quick-3.svg"));
  record.verdict.charts.resize(1);
  write_record(record, folder / "");
  EXPECT_TRUE(std::filesystem::exists(folder / "slab-paper-quick-1.svg"));
  EXPECT_FALSE(std::filesystem::exists(folder / "slab-paper-quick-2.svg"));
  EXPECT_FALSE(std::filesystem::exists(folder / "slab-paper-quick-3.svg"));
}

TEST(VerifyRecord, AreReadInTheOrderOfTheCasesWhoeverRanThem) {
  const TemporaryFolder folder;
  VerifyRecord record = made_record();
  for (const char* name : {"slab", "hydrostatic"}) {
    record.name = name;
    write_record(record, folder / "");
  }
  const auto records = read_records(folder / "", Effort::quick);
  ASSERT_EQ(records.size(), 2u);
  EXPECT_EQ(records[0].name, "hydrostatic");
  EXPECT_EQ(records[1].version, "0.1.0+gabc");
  EXPECT_TRUE(read_records(folder / "", Effort::full).empty());
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
  EXPECT_THAT(folder.read("index.html"), HasSubstr("An &amp; B"));
}

TEST(VerifyReport, GivesARemarkOfBothMethodsOnce) {
  const TemporaryFolder folder;
  VerifyRecord fast = made_record(), paper = made_record();
  fast.method = Method::fast;
  fast.verdict.remarks = {"of both", "of fast"};
  paper.verdict.remarks = {"of both", "of paper"};
  write_verify_page({fast, paper}, folder / "");
  EXPECT_THAT(folder.read("validation.md"),
              HasSubstr("\n`fast`, `paper`: of both\n\n`fast`: of fast\n\n`paper`: of paper\n"));
}

TEST(VerifyReport, SaysOfWhichVersionEachResultIs) {
  const TemporaryFolder folder;
  write_verify_page({made_record()}, folder / "");
  EXPECT_THAT(folder.read("validation.md"),
              HasSubstr("| `paper` | 1 of 3 | 12 | 0.1.0+gabc | 2026-01-02 | FAIL |"));
  EXPECT_THAT(folder.read("verify.json"), HasSubstr(R"("version": "0.1.0+gabc")"));
}

TEST(VerifyReport, CountsNoClaimThatIsOnlyTold) {
  Verdict verdict;
  verdict.claims = {Claim::at_most("error", "", 2, 1), Claim::at_least("speed", "m/s", 2, 1),
                    Claim::told("front", "m", 2, 1)};
  EXPECT_EQ(claims_met_text(verdict), "1 of 2");
}

TEST(VerifyReport, SaysWhereTheGateOfAMethodIsAnother) {
  VerifyRecord fast = made_record(), paper = made_record();
  fast.method = Method::fast;
  paper.verdict.claims = {Claim::within_share("speed \"x\"", "m/s", 3, 2, 0.05)};
  const TemporaryFolder folder;
  write_verify_page({fast, paper}, folder / "");
  EXPECT_THAT(folder.read("validation.md"),
              HasSubstr("| speed \"x\" | within 5 % of 2.353 m/s | 2.42 m/s | **3 m/s (within 5 % "
                        "of 2 m/s), fails** |"));
}

}  // namespace
}  // namespace sabo
