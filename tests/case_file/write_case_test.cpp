#include "io/case_file/write_case.hpp"

#include "case_file/support.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "case/material_presets.hpp"
#include "io/case_file/models.hpp"
#include "physics/viscosity_of_concentration.hpp"

namespace sabo {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

double number(double low, double high) {
  constexpr int steps = 1 << 30;
  return low + (high - low) * *rc::gen::inRange(0, steps + 1) / steps;
}
std::string text() {
  static const std::vector<std::string> pieces{"a", "e9", "`", " ",  "\"", "\\",
                                               "#", "'",  "é", "沢", "=",  "]"};
  std::string result;
  for (const std::string& piece :
       *rc::gen::container<std::vector<std::string>>(rc::gen::elementOf(pieces))) {
    result += piece;
  }
  return result;
}
bool chance() { return *rc::gen::arbitrary<bool>(); }

LineSource random_line(std::size_t least_points, bool has_z) {
  if (chance()) return {folder_with_files() / "path.gpkg", {}, false};
  LineSource result;
  result.has_z = has_z;
  const auto count = least_points + static_cast<std::size_t>(*rc::gen::inRange(0, 4));
  for (std::size_t i = 0; i < count; ++i) {
    const double z = has_z ? number(-10, 3000) : 0;
    result.coordinates.push_back({static_cast<double>(i) + number(0, 0.5), number(-1e7, 1e7), z});
  }
  return result;
}

StructureCase random_structure(const std::string& name) {
  StructureCase dam;
  dam.name = name;
  const bool has_z = chance();
  dam.line = random_line(2, has_z);
  dam.thickness = number(0.1, 20);
  if (!dam.line.has_z) (chance() ? dam.crest : dam.height) = number(3, 100);
  if (chance()) dam.notch = NotchCase{0, number(0.1, 9), number(0.1, 2), number(0, 3)};
  return dam;
}

/// Sets every number of a described struct within its range.
struct Randomise {
  void operator()(const Key& key, double& member) const {
    member = number(key.min_is_open ? key.min + 1e-3 : key.min, std::min(key.max, key.min + 50));
  }
  template <class T>
  void operator()(const Key&, T&) const {}
};

TerrainEditCase terrain_edit(const std::string& name) {
  TerrainEditCase edit{name,
                       random_line(3, false),
                       *rc::gen::element(TerrainEditKind::set, TerrainEditKind::lower,
                                         TerrainEditKind::raise, TerrainEditKind::smooth),
                       {},
                       {},
                       {}};
  if (edit.kind == TerrainEditKind::set) edit.elevation = number(-10, 100);
  if (edit.kind == TerrainEditKind::smooth) edit.radius = number(0.1, 9);
  const bool shifts = edit.kind == TerrainEditKind::lower || edit.kind == TerrainEditKind::raise;
  if (shifts) edit.by = number(0.1, 9);
  return edit;
}

/// Each kind of body, with the keys of its kind.
BodyCase random_body(const std::string& name) {
  BodyCase result;
  result.name = name;
  result.kind = *rc::gen::element(BodyKind::box, BodyKind::tank, BodyKind::mesh);
  if (result.kind == BodyKind::mesh) {
    result.file = folder_with_files() / "mesh.stl";
    result.frame = chance() ? BodyFrame::crs : BodyFrame::local;
    if (chance() || result.frame == BodyFrame::local)
      result.at = {{number(-9, 9), number(-9, 9), number(-9, 9)}};
    result.scale = number(0.001, 9);
    result.flow = chance() ? BodyFlow::outside : BodyFlow::inside;
    return result;
  }
  result.min = {{number(-9, 0), number(-9, 0), number(-9, 0)}};
  result.max = {{number(1, 9), number(1, 9), number(1, 9)}};
  result.rotation = number(-90, 90);
  if (result.kind == BodyKind::tank) result.open_top = chance();
  return result;
}

PlaneCase plane() {
  PlaneCase result;
  result.extent = {number(-9, 0), number(-9, 0), number(1, 9), number(1, 9)};
  result.slope = number(0, 40);
  if (chance()) result.cell_size = number(0.1, 1);
  return result;
}

/// Each way to give a release.
ReleaseCase arbitrary_release(const std::filesystem::path& folder) {
  ReleaseCase release;
  switch (*rc::gen::inRange(0, 6)) {
    case 0:
      release.polygon = random_line(3, chance());
      (chance() ? release.thickness : release.volume) = number(0.1, 10);
      release.normal = chance();
      break;
    case 1:
      release.polygon = {folder / "release.gpkg", {}, false};
      release.thickness_attribute = "d " + text();
      break;
    case 2:
      release.thickness_raster = folder / "release.tif";
      break;
    case 3:
      release.points = folder / "points.txt";
      release.points_offset = {number(-9, 9), number(-9, 9), number(-9, 9)};
      release.point_volume = number(0.1, 9);
      break;
    case 4:
      release.box = {{0, -1, 2, number(0.1, 9), number(0, 9), number(3, 9)}};
      break;
    default:
      release.dem_before = folder / "dem.tif";
      release.dem_after = folder / "release.tif";
      release.least_thickness = number(0, 2);
  }
  return release;
}

/// Takes back the keys that do not apply to the method or the wall law.
void make_consistent(NumericsCase& numerics) {
  const NumericsCase plain;
  if (numerics.method == Method::fast) {
    numerics.wall = WallLaw::voellmy;  // takes every key
    numerics.wall_friction_angle += 0.1;
    numerics.viscous_operator = plain.viscous_operator;
    numerics.boundary_stress = plain.boundary_stress;
    numerics.boundary_pressure = plain.boundary_pressure;
    numerics.viscous_cfl.reset();
  } else {
    numerics.wall = plain.wall;
    numerics.wall_friction_angle = plain.wall_friction_angle;
    numerics.wall_cohesion = plain.wall_cohesion;
    numerics.wall_turbulence = plain.wall_turbulence;
  }
}

/// Of no checkpoints none are kept, and of many not too many.
void make_consistent(RunCase& run) {
  if (run.checkpoint_interval == 0) run.kept_checkpoint_interval = 0;
  if (run.kept_checkpoint_interval != 0) run.kept_checkpoint_interval += 0.1;
}

Case arbitrary_case() {
  Case c;
  c.folder = folder_with_files();
  c.title = text();
  c.note = text();
  if (chance()) {
    c.terrain.plane = plane();
  } else {
    c.terrain.dem = c.folder / "dem.tif";
    c.terrain.assume_metres = chance();
    if (chance()) c.terrain.crop = {{number(-9, 0), number(-9, 0), number(1, 9), number(1, 9)}};
    if (chance()) c.terrain.crs = "EPSG:32652";
    if (chance()) c.terrain.cell_size = number(0.1, 10);
  }
  c.release = arbitrary_release(c.folder);
  c.material.law = *rc::gen::elementOf(all_rheologies());
  std::visit([](auto& law) { law.describe(Randomise{}); }, c.material.law);
  if (has_yield(c.material.law)) c.material.yield.describe(Randomise{});
  if (chance() && viscosity_of(c.material.law)) {
    c.material.concentration = number(1, 60);
    set_viscosity(c.material.law, viscosity_of_concentration(*c.material.concentration));
  }
  for (int i = 0; i < *rc::gen::inRange(0, 3); ++i) {
    c.structures.push_back(random_structure("dam " + std::to_string(i)));
    c.bodies.push_back(random_body("body " + std::to_string(i)));
    c.sections.push_back({text() + std::to_string(i), random_line(2, false)});
    c.zones.push_back({text() + std::to_string(i), random_line(3, false), {}, text()});
    if (chance()) c.zones.back().observed = number(0, 9);
    c.terrain.edits.push_back(terrain_edit("edit " + std::to_string(i)));
  }
  if (chance()) c.path.line = random_line(2, chance());
  if (chance()) c.references.push_back({"a " + text(), number(0, 9), std::nullopt, number(0, 9)});
  c.numerics.describe(Randomise{});
  c.numerics.reference_speed += 0.1;  // for the case without gravity
  c.numerics.threads = *rc::gen::inRange(0, 9);
  c.numerics.viscous_operator = chance() ? ViscousOperator::nested : ViscousOperator::morris;
  make_consistent(c.numerics);
  c.run.describe(Randomise{});
  make_consistent(c.run);
  return c;
}

RC_GTEST_PROP(WriteCase, ReadingItBackGivesTheSameCase, ()) {
  const Case c = arbitrary_case();
  const std::string text = write_case(c);
  Faults faults;
  const Case back = read_case_text(text, "/", faults);
  for (const Fault& fault : faults.list()) RC_FAIL(to_string(fault));
  RC_ASSERT(write_case(back) == text);
  // The text could leave something out on both ways; a few members are compared themselves.
  RC_ASSERT(back.title == c.title);
  RC_ASSERT(back.numerics.spacing == c.numerics.spacing);
  RC_ASSERT(back.numerics.wall == c.numerics.wall);
  RC_ASSERT(back.numerics.wall_turbulence == c.numerics.wall_turbulence);
  RC_ASSERT(back.numerics.viscous_operator == c.numerics.viscous_operator);
  RC_ASSERT(back.material.law.index() == c.material.law.index());
  RC_ASSERT(back.material.yield.cohesion == c.material.yield.cohesion);
  RC_ASSERT(back.release.polygon.coordinates == c.release.polygon.coordinates);
  RC_ASSERT(back.structures.size() == c.structures.size());
  RC_ASSERT(back.terrain.crop == c.terrain.crop);
  RC_ASSERT(back.terrain.crs == c.terrain.crs);
  RC_ASSERT(back.terrain.cell_size == c.terrain.cell_size);
  RC_ASSERT(back.material.concentration == c.material.concentration);
  RC_ASSERT(viscosity_of(back.material.law) == viscosity_of(c.material.law));
  RC_ASSERT(back.release.thickness_attribute == c.release.thickness_attribute);
  RC_ASSERT(back.release.dem_before == c.release.dem_before);
  RC_ASSERT(back.release.least_thickness == c.release.least_thickness);
  RC_ASSERT(back.terrain.edits.size() == c.terrain.edits.size());
  for (std::size_t k = 0; k < c.terrain.edits.size(); ++k) {
    RC_ASSERT(back.terrain.edits[k].kind == c.terrain.edits[k].kind);
    RC_ASSERT(back.terrain.edits[k].by == c.terrain.edits[k].by);
    RC_ASSERT(back.terrain.edits[k].radius == c.terrain.edits[k].radius);
    RC_ASSERT(back.terrain.edits[k].elevation == c.terrain.edits[k].elevation);
  }
  RC_ASSERT(back.terrain.plane.has_value() == c.terrain.plane.has_value());
  if (c.terrain.plane) RC_ASSERT(back.terrain.plane->extent == c.terrain.plane->extent);
  RC_ASSERT(back.release.box == c.release.box);
  RC_ASSERT(back.bodies.size() == c.bodies.size());
  for (std::size_t k = 0; k < c.bodies.size(); ++k) {
    RC_ASSERT(back.bodies[k].kind == c.bodies[k].kind);
    RC_ASSERT(back.bodies[k].max == c.bodies[k].max);
    RC_ASSERT(back.bodies[k].at == c.bodies[k].at);
    RC_ASSERT(back.bodies[k].flow == c.bodies[k].flow);
  }
  RC_ASSERT(back.zones.size() == c.zones.size());
  for (std::size_t k = 0; k < c.zones.size(); ++k) {
    RC_ASSERT(back.zones[k].observed == c.zones[k].observed);
    RC_ASSERT(back.zones[k].source == c.zones[k].source);
  }
}

TEST(WriteCase, KeysHaveTheirHelpAndRange) {
  Case c;
  c.numerics.spacing = 0.75;
  c.release.volume = 8863;
  const std::string text = write_case(c);
  EXPECT_THAT(text, HasSubstr("# internal friction angle phi (a number from 0 to 60 deg)\n"
                              "friction_angle = 0\n"));
  EXPECT_THAT(text, HasSubstr("\n[numerics]\n"));
  EXPECT_THAT(text, HasSubstr("\nspacing = 0.75\n"));
  EXPECT_THAT(text, HasSubstr("\nvolume = 8863\n"));
  EXPECT_THAT(text, HasSubstr("\n#thickness =\n"));
  EXPECT_THAT(text, HasSubstr("\n#[[structure]]\n"));
}

TEST(WriteCase, LinesAreNotLong) {
  std::istringstream lines(defaults_text());
  for (std::string one; std::getline(lines, one);) EXPECT_LE(one.size(), 100u) << one;
}

TEST(WriteCase, DefaultsLackOnlyWhatIsRequired) {
  EXPECT_THAT(
      messages(defaults_text()),
      ElementsAre(HasSubstr("numerics.spacing: is missing"), HasSubstr("run.duration: is missing"),
                  HasSubstr("terrain: has no ground"), HasSubstr("release: nothing is released")));
}

TEST(KeysMarkdown, HasEveryTableAndRheology) {
  const std::string text = keys_markdown();
  EXPECT_THAT(text, HasSubstr("## `[numerics]`\n\nThe method.\n"));
  EXPECT_THAT(text, HasSubstr("## `[[structure]]`"));
  EXPECT_THAT(text, HasSubstr("## `[structure.notch]`"));
  EXPECT_THAT(text, HasSubstr("| `spacing` | required | a number from 1e-6 to 10000 m |"));
  EXPECT_THAT(text, HasSubstr("## `[[terrain.edit]]`"));
  EXPECT_THAT(text, HasSubstr("| [`general_cross`](rheology/general_cross.md) |"));
  EXPECT_THAT(keys_table(list_keys(GeneralCross{})),
              HasSubstr("| `time_constant` | `1` | a number from 0 to 1e9 s |"));
}

TEST(Models, ListsEveryLawWithItsKeys) {
  const std::string text = models_text();
  for (const Rheology& law : all_rheologies()) {
    EXPECT_THAT(text, HasSubstr("rheology = \"" + std::string(name_of(law)) + "\": "));
  }
  EXPECT_THAT(text,
              HasSubstr("  cohesion               0       yield stress without normal stress\n"
                        "                                 a number from 0 to 1e9 Pa\n"));
  for (const MaterialPreset& preset : material_presets()) {
    EXPECT_THAT(text, HasSubstr("preset = \"" + std::string(preset.name) + "\": "));
    EXPECT_THAT(text, HasSubstr("Source: " + std::string(preset.source)));
  }
  EXPECT_THAT(text, HasSubstr("viscosity = 33.9, viscosity_ratio = 1000, cohesion = 22.9"));
}

}  // namespace
}  // namespace sabo
