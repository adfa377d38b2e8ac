#include "io/case_file/templates.hpp"

#include <algorithm>

#include "case_file/support.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sabo {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

YohutagawaNumbers example_numbers() {
  YohutagawaNumbers numbers;
  numbers.notch_centre = 17.5;
  numbers.above_dam = {{{610, -20}, {610, 20}}};
  numbers.below_dam = {{{640, -20}, {640, 20}}};
  for (int k = 0; k < 4; ++k) {
    const double x = 100.0 * k;
    numbers.zones[k] = {"zone " + std::to_string(k), {{{x, 0}, {x + 90, 0}, {x + 90, 9}, {x, 9}}}};
  }
  return numbers;
}

TEST(Templates, AreNamed) {
  ASSERT_EQ(templates.size(), 4u);
  EXPECT_EQ(templates[0].name, "yohutagawa");
  EXPECT_EQ(templates[1].name, "valley-from-dem");
  EXPECT_EQ(templates[2].name, "dam-break");
  EXPECT_EQ(templates[3].name, "flume");
}

TEST(Templates, YohutagawaReadsBack) {
  Faults faults;
  const Case c = read_case_text(yohutagawa_text(example_numbers()), folder_with_files(), faults);
  for (const Fault& fault : faults.list()) ADD_FAILURE() << to_string(fault);
  EXPECT_THAT(c.title, HasSubstr("generated terrain"));
  EXPECT_THAT(c.note, HasSubstr("not a validation"));
  EXPECT_EQ(c.release.volume, 8863.0);
  EXPECT_EQ(c.material.density, 1726);
  EXPECT_EQ(std::get<Cross>(c.material.law).mu_inf, 1255);
  EXPECT_EQ(c.material.yield.friction_angle, 28);
  ASSERT_EQ(c.structures.size(), 1u);
  EXPECT_EQ(c.structures[0].height, 8.0);
  ASSERT_TRUE(c.structures[0].notch);
  EXPECT_EQ(c.structures[0].notch->centre, 17.5);
  EXPECT_EQ(c.structures[0].notch->width, 10);
  ASSERT_EQ(c.sections.size(), 2u);
  EXPECT_EQ(c.sections[0].name, "p1");
  EXPECT_THAT(c.sections[1].line.coordinates,
              ElementsAre(ElementsAre(640, -20, 0), ElementsAre(640, 20, 0)));
  ASSERT_EQ(c.zones.size(), 4u);
  EXPECT_EQ(c.zones[1].polygon.coordinates[2], (std::array{190.0, 9.0, 0.0}));
  EXPECT_EQ(c.zones[2].observed, 0.3);
  EXPECT_FALSE(c.zones[3].observed);
  ASSERT_EQ(c.references.size(), 2u);
  EXPECT_EQ(c.references[0].trapped, 5353.0);
  EXPECT_EQ(c.numerics.spacing, 0.75);
  EXPECT_EQ(c.numerics.reference_speed, 20);
  EXPECT_EQ(c.run.duration, 300);
}

TEST(Templates, YohutagawaLacksOnlyItsFiles) {
  const TemporaryFolder empty;
  Faults faults;
  read_case_text(yohutagawa_text(example_numbers()), empty.path(), faults);
  EXPECT_EQ(faults.list().size(), 4u);
  for (const Fault& fault : faults.list())
    EXPECT_THAT(fault.problem, HasSubstr("there is no file"));
}

TEST(Templates, ValleyReadsBack) {
  EXPECT_THAT(messages(valley_from_dem_text()), testing::IsEmpty());
}

TEST(Templates, ValleyWithItsDamAndSectionReadsBack) {
  std::string text = valley_from_dem_text();
  for (std::size_t at = 0; (at = text.find("\n#", at)) != std::string::npos; ++at) {
    if (text.at(at + 2) != ' ') text.erase(at + 1, 1);  // "#key" becomes "key"
  }
  Faults faults;
  const Case c = read_case_text(text, folder_with_files(), faults);
  for (const Fault& fault : faults.list()) ADD_FAILURE() << to_string(fault);
  EXPECT_EQ(c.structures.size(), 1u);
  EXPECT_EQ(c.sections.size(), 1u);
  EXPECT_EQ(c.zones.size(), 1u);
  EXPECT_EQ(c.terrain.edits.size(), 1u);
}

}  // namespace
}  // namespace sabo
