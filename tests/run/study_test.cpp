#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>

#include "support/temporary_folder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "run/batch_record.hpp"
#include "run/new_case.hpp"
#include "run/scene.hpp"
#include "run/simulation.hpp"
#include "run/study_page.hpp"
#include "run/study_plan.hpp"
#include "run/study_table.hpp"

namespace sabo {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

BatchRecord record(double spacing, std::vector<std::pair<std::string, double>> quantities,
                   int member = 0) {
  BatchRecord made;
  made.spacing = spacing;
  made.member = member;
  made.at_rest = true;
  made.median_layers = 6;
  made.quantities = std::move(quantities);
  return made;
}

// 100 - 8 h: first order, 100 m at zero. GCI 1.25 x 8 / (2 - 1).
TEST(StudyTable, ExtrapolatesAPowerLaw) {
  const StudyTable table =
      study_table({record(4, {{"front run-out [m]", 68}}), record(1, {{"front run-out [m]", 92}}),
                   record(2, {{"front run-out [m]", 84}})});
  EXPECT_THAT(table.spacings, ElementsAre(4, 2, 1));
  const PageTable page = quantities_table(table);
  EXPECT_THAT(page.header, ElementsAre("", "4 m", "2 m", "1 m", "uncertainty", "order",
                                       "extrapolated to 0", "remark"));
  ASSERT_EQ(page.rows.size(), 1u);
  EXPECT_THAT(page.rows[0], ElementsAre("front run-out [m]", "68.00", "84.00", "92.00", "10.00",
                                        "1.00", "100.0", ""));
}

TEST(StudyTable, SaysWhatASeriesDoesNotShow) {
  const std::vector<BatchRecord> records{
      record(4, {{"a [m]", 1}, {"b [m]", 5}, {"c [m]", 1}, {"d [m]", 1}}),
      record(2, {{"a [m]", 3}, {"b [m]", 5}, {"c [m]", 2}, {"d [m]", 2.1}}),
      record(1, {{"a [m]", 2}, {"b [m]", 5}, {"e [s]", 7}, {"c [m]", 4}, {"d [m]", 3}})};
  const PageTable page = quantities_table(study_table(records));
  ASSERT_EQ(page.rows.size(), 5u);
  EXPECT_THAT(page.rows[0], ElementsAre("a [m]", "1.000", "3.000", "2.000", "-", "-", "-",
                                        "no order: 1.000 to 3.000"));
  EXPECT_THAT(page.rows[1],
              ElementsAre("b [m]", "5.000", "5.000", "5.000", "0", "-", "5.000", "unchanged"));
  EXPECT_EQ(page.rows[2].back(), "no order: 1.000 to 4.000") << "growing changes";
  EXPECT_EQ(page.rows[3].back(), "far from converged") << "order log2(1.1 / 0.9) = 0.29";
  EXPECT_EQ(page.rows[3][6], "-");
  EXPECT_THAT(page.rows[4],
              ElementsAre("e [s]", "-", "-", "7.000", "-", "-", "-", "at one spacing only"));
}

TEST(StudyTable, OfTwoSpacingsSaysWhatItAssumes) {
  const PageTable page =
      quantities_table(study_table({record(2, {{"a [m]", 3}}), record(1, {{"a [m]", 2}})}));
  EXPECT_THAT(page.rows[0], ElementsAre("a [m]", "3.000", "2.000", "3.000", "1.00", "1.000",
                                        "two spacings: first order is assumed"));
}

TEST(StudyTable, ShowsNoVolumeBelowZero) {
  const std::vector<BatchRecord> records{record(2, {{"a [m3]", 3}}), record(1, {{"a [m3]", 1}})};
  const StudyTable table = study_table(records);
  const PageTable page = quantities_table(table);
  EXPECT_EQ(page.rows[0][5], "-") << "1 - 2";
  EXPECT_THAT(page.rows[0].back(), HasSubstr("extrapolates below zero"));
  const TemporaryFolder folder;
  write_study(folder / "", {}, records, table, {});
  std::ifstream csv(folder / "table.csv");
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(line,
            "quantity,at 2 m,at 1 m,convergence,order,extrapolated,uncertainty,lowest,highest");
  std::getline(csv, line);
  EXPECT_THAT(line, HasSubstr(",1,,")) << "of first order, without a limit";
}

// Means 10 and 11, deviations sqrt(2) each: the standard error of the change is sqrt(2/2 + 2/2).
TEST(StudyTable, TellsAChangeFromTheScatterOfTheMembers) {
  const PageTable page =
      quantities_table(study_table({record(2, {{"a [m]", 9}}, 1), record(2, {{"a [m]", 11}}, 2),
                                    record(1, {{"a [m]", 10}}, 1), record(1, {{"a [m]", 12}}, 2)}));
  EXPECT_EQ(page.rows[0][1], "10.00 (s 1.4)");
  EXPECT_THAT(page.rows[0].back(), HasSubstr("last change within the scatter"));
  const PageTable clear =
      quantities_table(study_table({record(2, {{"a [m]", 9}}, 1), record(2, {{"a [m]", 11}}, 2),
                                    record(1, {{"a [m]", 20}}, 1), record(1, {{"a [m]", 22}}, 2)}));
  EXPECT_EQ(clear.rows[0].back(), "two spacings: first order is assumed");
}

TEST(StudyTable, WarnsOfCloseSpacingsThinFlowsAndMotionAtTheEnd) {
  std::vector<BatchRecord> records{record(2, {}), record(1, {})};
  EXPECT_TRUE(study_warnings(records, study_table(records)).empty());
  records[1].spacing = 1.6;
  records[0].median_layers = 3.9;
  records[0].at_rest = false;
  EXPECT_THAT(study_warnings(records, study_table(records)),
              ElementsAre(HasSubstr("2 and 1.6 m are closer"), HasSubstr("3.9 particles deep"),
                          HasSubstr("1 of 2 runs ended while")));
}

TEST(NumberText, HasFourDigits) {
  EXPECT_EQ(number_text(0), "0");
  EXPECT_EQ(number_text(8863.4), "8863");
  EXPECT_EQ(number_text(123456), "123456");
  EXPECT_EQ(number_text(-31.4159), "-31.42");
  EXPECT_EQ(number_text(0.0123456), "0.01235");
  EXPECT_EQ(number_text(474.77, 2), "475");
  EXPECT_EQ(number_text(0.2052, 2), "0.21");
}

class Study : public testing::Test {
 protected:
  void SetUp() override { new_case("yohutagawa", folder_ / "case"); }
  StudyRequest request(std::vector<double> spacings, int members = 1) const {
    return {folder_ / "case",
            std::move(spacings),
            members,
            {{"run", "duration", 0.05}, {"numerics", "threads", std::int64_t{1}}}};
  }
  std::string fault_of(const StudyRequest& wrong) const {
    try {
      study_plan(wrong);
    } catch (const CaseError& error) {
      return to_string(error.faults().front());
    }
    return "none";
  }

  TemporaryFolder folder_;
};

TEST_F(Study, PlansFromTheCoarsestSpacing) {
  const std::vector<StudyRun> runs = study_plan(request({3, 4.5}));
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[0].folder, "spacing-4.5");
  EXPECT_EQ(runs[0].c.numerics.spacing, 4.5);
  EXPECT_EQ(runs[0].c.release.jitter, 0);
  EXPECT_EQ(runs[1].folder, "spacing-3");
}

TEST_F(Study, GivesEachMemberItsSeed) {
  const std::vector<StudyRun> runs = study_plan(request({4, 5}, 2));
  ASSERT_EQ(runs.size(), 4u);
  EXPECT_EQ(runs[3].folder, "spacing-4-member-2");
  EXPECT_EQ(runs[3].c.release.seed, 2);
  EXPECT_EQ(runs[3].c.release.jitter, member_jitter);
  EXPECT_EQ(runs[0].c.release.seed, 1);
  StudyRequest wide = request({4, 5}, 2);
  wide.overrides.push_back({"release", "jitter", 0.25});
  EXPECT_EQ(study_plan(wide)[0].c.release.jitter, 0.25);
}

// What the model and the measurements take from the release must not differ between members.
TEST_F(Study, JitterMovesParticlesAndNothingElse) {
  Faults faults;
  const Scene still = make_scene(study_plan(request({4, 5}))[1].c, faults);
  const Scene moved = make_scene(study_plan(request({4, 5}, 2))[3].c, faults);
  ASSERT_TRUE(faults.empty());
  EXPECT_EQ(moved.release_depth, still.release_depth);
  EXPECT_EQ(moved.release_centre, still.release_centre);
  EXPECT_EQ(moved.release.density, still.release.density);
  EXPECT_EQ(moved.release.mass, still.release.mass);
  double farthest = 0;
  for (std::size_t i = 0; i < still.release.size(); ++i) {
    const Vec3d shift = moved.release.position[i] - still.release.position[i];
    farthest = std::max({farthest, std::abs(shift.x), std::abs(shift.y)});
  }
  EXPECT_LE(farthest, member_jitter * 4);
  EXPECT_GT(farthest, 0.8 * member_jitter * 4);
}

TEST_F(Study, RefusesWhatIsNoStudy) {
  EXPECT_THAT(fault_of(request({4})), HasSubstr("--spacings: has fewer than two; give two"));
  EXPECT_THAT(fault_of(request({4, 3, 4})), HasSubstr("has 4 m twice"));
  EXPECT_THAT(fault_of(request({4, 0})), HasSubstr("0 m is no spacing"));
  EXPECT_THAT(fault_of(request({4, std::nan("")})), HasSubstr("nan m is no spacing"));
  EXPECT_THAT(fault_of(request({4, 3}, 0)), HasSubstr("--members: 0 is out of range"));
  EXPECT_THAT(fault_of(request({4, 300})), HasSubstr("at 300 m the release is too thin"));
}

TEST_F(Study, KnowsAFinishedRunOfTheSameCaseAndInputs) {
  Case c = study_plan(request({4, 5}))[1].c;
  const auto run_folder = folder_ / "run";
  EXPECT_FALSE(finished_record(run_folder, c)) << "nothing is there";
  ASSERT_EQ(run_case(c, {run_folder, FormerRun::kept, {}, nullptr}).end, RunEnd::finished);
  const auto found = finished_record(run_folder, c);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->simulated, 0.05);
  EXPECT_EQ(found->spacing, 4);
  EXPECT_GT(found->particles, 50);
  EXPECT_FALSE(found->at_rest);
  EXPECT_EQ(found->quantities.front().first, "front run-out [m]");
  const auto is_trapped = [](const auto& quantity) {
    return quantity.first == "trapped by dam [m3]" && std::abs(quantity.second - 8863) < 1e-3;
  };
  EXPECT_EQ(std::ranges::count_if(found->quantities, is_trapped), 1) << "all of it";

  c.numerics.threads = 2;
  EXPECT_TRUE(finished_record(run_folder, c)) << "threads do not change the results";
  c.numerics.reference_speed = 21;
  EXPECT_FALSE(finished_record(run_folder, c)) << "another case";
  c.numerics.reference_speed = 20;
  EXPECT_TRUE(finished_record(run_folder, c));
  std::ofstream(folder_ / "case" / "release.tif", std::ios::app) << "x";
  EXPECT_FALSE(finished_record(run_folder, c)) << "another input";
}

}  // namespace
}  // namespace sabo
