#include "run/preview.hpp"

#include "support/temporary_folder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/case_file/read_case.hpp"
#include "run/new_case.hpp"

namespace sabo {
namespace {

using testing::HasSubstr;
using testing::Not;

const TemporaryFolder& example_folder() {
  static const TemporaryFolder folder;
  static const bool is_written = [] {
    new_case("yohutagawa", folder / "demo");
    return true;
  }();
  (void)is_written;
  return folder;
}

/// The preview of the example with some keys changed.
std::string preview_with(const std::vector<Override>& overrides) {
  Faults faults;
  const Case c = read_case(example_folder() / "demo", faults, overrides);
  const Scene scene = make_scene(c, faults);
  faults.throw_if_any();
  return preview_text(c, scene);
}

TEST(Preview, DescribesTheExample) {
  const std::string text = preview_with({});
  EXPECT_THAT(text, HasSubstr("consistency check, not a validation"));
  EXPECT_THAT(text, HasSubstr("1201 x 161 cells of 1 x 1 m, EPSG:32652"));
  EXPECT_THAT(text, HasSubstr("Release     8863 m3"));
  EXPECT_THAT(text, HasSubstr("notch 10 m wide and 1.5 m deep"));
  EXPECT_THAT(text, HasSubstr("p2: 80.0 m long"));
  EXPECT_THAT(text, HasSubstr("(given)"));
}

TEST(Preview, NamesTheRulingTimeStep) {
  // dp = 0.75 m: h = 1.125 m, c0 = 10 x 20 m/s, nu = 1.255e6 / 1726 m2/s. Acoustic: 0.2 h / c0 =
  // 1.125e-3 s; viscous: 0.6 h^2 / nu = 1.044e-3 s, 287 255 times in 300 s.
  const std::string fine = preview_with({});
  EXPECT_THAT(fine, HasSubstr("h = 1.125 m, sound speed 200 m/s"));
  EXPECT_THAT(fine, HasSubstr("time step 0.00104 s, viscous limit while at rest (0.00113 s"));
  EXPECT_THAT(fine, HasSubstr("about 287 thousand steps for 300 s"));
  // Twice the spacing: acoustic 2.25e-3 s, viscous 4.18e-3 s.
  const std::string coarse = preview_with({{"numerics", "spacing", 1.5}, {"run", "duration", 9.0}});
  EXPECT_THAT(coarse, HasSubstr("time step 0.00225 s, acoustic limit\n"));
  EXPECT_THAT(coarse, HasSubstr("about 4000 steps for 9 s"));
}

TEST(Preview, WarnsOfAReleaseOfFewLayers) {
  EXPECT_THAT(preview_with({}), Not(HasSubstr("particles deep")));
  EXPECT_THAT(preview_with({{"numerics", "spacing", 2.0}}), HasSubstr("particles deep"));
}

TEST(Preview, WarnsOfADamThinnerThanTheKernel) {
  // 2 h - dp = 2 dp is 1.5 m at 0.75 m and 4 m at 2 m; the dam is 3.2 m thick.
  EXPECT_THAT(preview_with({}), Not(HasSubstr("through it")));
  EXPECT_THAT(preview_with({{"numerics", "spacing", 2.0}}),
              HasSubstr("\"dam\" is 3.2 m thick: the flow on one side feels that on the other "
                        "through it below 4.00 m"));
}

// 2 m of water-like flow at sqrt(2 g 2) = 6.3 m/s: tan(11.3 deg) x 1800 x 9.81 x 2 = 7.1 kPa and
// 1800 x 9.81 x 6.3^2 / 500 = 1.4 kPa are asked for; 20 Pa s over 0.25 m carry 0.5 kPa, 2000 Pa
// s 50.
TEST(Preview, WarnsOfAFluidThatDoesNotFeelItsWall) {
  const auto preview = [](double viscosity, const std::string& wall) {
    const TemporaryFolder folder;
    Faults faults;
    const Case c = read_case_text(
        "[terrain.plane]\nextent = [0, 0, 30, 30]\nslope = 10\n[material]\ndensity = 1800\n"
        "rheology = \"newtonian\"\nviscosity = " +
            std::to_string(viscosity) +
            "\n[release]\npolygon = [[5, 5], [9, 5], [9, 9], [5, 9]]\nthickness = 2\n"
            "[run]\nduration = 1\n[numerics]\nspacing = 0.5\n" +
            wall,
        folder / "", faults);
    const Scene scene = make_scene(c, faults);
    faults.throw_if_any();
    return preview_text(c, scene);
  };
  const std::string voellmy = "wall = \"voellmy\"\nwall_friction_angle = 11.3\n";
  EXPECT_THAT(preview(20, voellmy), HasSubstr("asks for 8.4 kPa under 2 m of flow at 6.3 m/s; this "
                                              "material carries 0.5 kPa"));
  EXPECT_THAT(preview(2000, voellmy), Not(HasSubstr("asks for")));
  EXPECT_THAT(preview(20, ""), Not(HasSubstr("asks for")));
}

TEST(Preview, ComparesThePathWithTheEffectiveFriction) {
  // The path falls 291 m over 1206 m: 13.6 degrees. r_u = 0.6 leaves atan(0.4 tan 28) = 12.0.
  EXPECT_THAT(preview_with({}),
              HasSubstr("mean slope of 13.6 deg is below the effective friction angle of 28.0"));
  EXPECT_THAT(preview_with({{"material", "pore_pressure_ratio", 0.6}}),
              Not(HasSubstr("friction angle")));
}

}  // namespace
}  // namespace sabo
