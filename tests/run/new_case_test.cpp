#include "run/new_case.hpp"

#include <filesystem>

#include "support/fault_of.hpp"
#include "support/temporary_folder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/section.hpp"
#include "io/case_file/read_case.hpp"
#include "io/case_file/templates.hpp"
#include "io/gis/crs.hpp"
#include "io/gis/gdal_errors.hpp"
#include "run/scene.hpp"
#include "terrain/valley.hpp"

namespace sabo {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

void expect_no_faults(const Faults& faults) {
  for (const Fault& fault : faults.list()) ADD_FAILURE() << to_string(fault);
}

/// The example, written and read once.
struct Example {
  Example() {
    new_case("yohutagawa", folder / "demo");
    c = read_case(folder / "demo", faults);
    c.numerics.spacing = 2;
    if (faults.empty()) scene = make_scene(c, faults);
  }
  /// A place of the valley in the solver frame; the valley's x = 0, y = 0 is at (0, 80) there.
  Vec3d place(double x, double y) const {
    return {350'000 + x - scene.frame.origin_x, 3'130'000 + y - scene.frame.origin_y, 0};
  }
  TemporaryFolder folder;
  Faults faults;
  Case c;
  Scene scene;
};

const Example& example() {
  static const Example instance;
  return instance;
}

TEST(NewCase, YohutagawaIsReadWithoutAFault) { expect_no_faults(example().faults); }

TEST(NewCase, YohutagawaHasTheTerrainOfTheValley) {
  const Scene& scene = example().scene;
  {
    const GdalErrors errors;
    EXPECT_THAT(name_of(crs_of(scene.frame.crs)), StartsWith("EPSG:32652"));
  }
  for (const double x : {40.0, 300.0, 620.0, 1100.0}) {
    const Vec3d place = example().place(x, 10);
    EXPECT_NEAR(scene.surface->height(place.x, place.y), valley_elevation(x, 10), 1e-3) << x;
  }
}

TEST(NewCase, YohutagawaReleasesThePublishedVolumeInTheSource) {
  const Scene& scene = example().scene;
  EXPECT_NEAR(scene.release_volume, 8863, 1e-6);
  // The source reaches from x = 25 m over 8863 / (4/3 x 5 x 14) = 95 m, 28 m wide.
  EXPECT_NEAR(scene.release_area, 95 * 28, 0.02 * 95 * 28);
  EXPECT_NEAR(scene.release_centre.x, example().place(25 + 95 / 2.0, 0).x, 1);
}

TEST(NewCase, YohutagawaHasItsDamAcrossTheBed) {
  const Scene& scene = example().scene;
  ASSERT_EQ(scene.dams.size(), 1u);
  const CheckDam& dam = scene.dams.front();
  // Its height counts from the lowest ground along the line, which is not perpendicular to the
  // slope: within 0.3 m of 8 m above the bed on the axis.
  EXPECT_NEAR(dam.crest, valley_bed(620) + 8, 0.3);
  EXPECT_EQ(dam.thickness, 3.2);
  ASSERT_TRUE(dam.notch);
  const LinePlace axis =
      project(dam.axis, example().place(620, 0).x, example().place(0, valley_axis(620)).y);
  EXPECT_NEAR(axis.station, dam.notch->centre, 0.01);
  EXPECT_NEAR(axis.offset, 0, 1e-6);
}

TEST(NewCase, YohutagawaSectionsCountDownTheValleyAsPositive) {
  const Scene& scene = example().scene;
  ASSERT_EQ(scene.sections.size(), 2u);
  const Vec3d before_p1 = example().place(599, valley_axis(599));
  const Vec3d behind_p1 = example().place(601, valley_axis(601));
  const Vec3d before_p2 = example().place(639, valley_axis(639));
  const Vec3d behind_p2 = example().place(641, valley_axis(641));
  Section p1(scene.sections[0].line);
  Section p2(scene.sections[1].line);
  p1.record(before_p1, behind_p1, 3);
  p1.record(behind_p1, before_p2, 5);  // between the two
  p2.record(behind_p1, before_p2, 5);
  p2.record(before_p2, behind_p2, 7);
  EXPECT_EQ(scene.sections[0].name, "p1");
  EXPECT_EQ(p1.total(), (SectionVolumes{3, 0}));
  EXPECT_EQ(p2.total(), (SectionVolumes{7, 0}));
}

TEST(NewCase, YohutagawaComesWithItsReferences) {
  const Case& c = example().c;
  ASSERT_EQ(c.references.size(), 2u);
  EXPECT_EQ(c.references[0].trapped, 5353.0);
  EXPECT_EQ(c.references[1].beyond, 3076.0);
}

TEST(NewCase, ValleyFromDemLacksOnlyItsFiles) {
  const TemporaryFolder folder;
  new_case("valley-from-dem", folder / "mine");
  Faults faults;
  read_case(folder / "mine", faults);
  EXPECT_EQ(faults.list().size(), 2u);
  for (const Fault& fault : faults.list())
    EXPECT_THAT(fault.problem, HasSubstr("there is no file"));
}

TEST(NewCase, WritesEveryTemplate) {
  for (const Template& entry : templates) {
    const TemporaryFolder folder;
    new_case(std::string(entry.name), folder / "a" / "b");
    EXPECT_TRUE(std::filesystem::exists(folder / "a" / "b" / "case.toml")) << entry.name;
  }
}

TEST(NewCase, LeavesAFolderWithFilesAlone) {
  const TemporaryFolder folder;
  folder.write("mine.txt", "");
  const Fault fault = fault_of([&] { new_case("yohutagawa", folder / ""); });
  EXPECT_THAT(fault.problem, HasSubstr("has files in it"));
  EXPECT_EQ(folder.file_count(), 1u);
  EXPECT_THAT(fault_of([&] { new_case("yohutagawa", folder / "mine.txt"); }).problem,
              HasSubstr("is a file"));
}

TEST(NewCase, SuggestsATemplate) {
  const TemporaryFolder folder;
  const Fault near = fault_of([&] { new_case("valley_from_dem", folder / "x"); });
  EXPECT_THAT(near.remedy, HasSubstr("did you mean \"valley-from-dem\"?"));
  const Fault far = fault_of([&] { new_case("glacier", folder / "x"); });
  EXPECT_THAT(far.remedy, HasSubstr("yohutagawa, valley-from-dem"));
  EXPECT_EQ(folder.file_count(), 0u);
}

}  // namespace
}  // namespace sabo
