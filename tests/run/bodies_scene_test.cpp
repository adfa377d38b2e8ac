#include <cmath>

#include "support/temporary_folder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/case_file/read_case.hpp"
#include "math/angle.hpp"
#include "physics/equation_of_state.hpp"
#include "run/new_case.hpp"
#include "run/preview.hpp"
#include "run/preview_picture.hpp"
#include "run/scene.hpp"
#include "run/scene_bodies.hpp"
#include "run/simulation.hpp"
#include "run/state_pictures.hpp"

// Cases on a plane with bodies, particles of 0.1 m.

namespace sabo {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

struct PlaneWorld {
  TemporaryFolder folder;
  Faults faults;

  Scene make(const std::string& keys, const std::string& plane = "extent = [0, 0, 10, 6]") {
    c = read_case_text(
        "[terrain.plane]\n" + plane + "\n[numerics]\nspacing = 0.1\n[run]\nduration = 1\n" + keys,
        folder / "", faults);
    return make_scene(c, faults);
  }
  std::vector<std::string> messages() const {
    std::vector<std::string> texts;
    for (const Fault& fault : faults.list()) texts.push_back(to_string(fault));
    return texts;
  }
  Case c;
};

const std::string pool = "[release]\nbox = [1, 1, 0, 3, 2, 0.5]\n";

const std::string unit_cube = R"(v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 0 0 1
v 1 0 1
v 1 1 1
v 0 1 1
f 1 4 3 2
f 5 6 7 8
f 1 2 6 5
f 6 2 3 7
f 3 4 8 7
f 4 1 5 8
)";

TEST(PlaneScene, ReleasesABoxUnderItsOwnPressure) {
  PlaneWorld world;
  const Scene scene = world.make(pool);
  ASSERT_TRUE(world.faults.empty()) << world.messages().front();
  EXPECT_NEAR(scene.release_volume, 1, 1e-12);
  EXPECT_NEAR(scene.release_area, 2, 1e-12);
  EXPECT_NEAR(scene.release_depth, 0.5, 1e-12);
  EXPECT_TRUE(scene.frame.crs.empty());
  const Tait state{1726, 10 * std::sqrt(9.81 * 0.5)};
  for (std::size_t i = 0; i < scene.release.size(); ++i) {
    const double expected = 1726 * 9.81 * (0.5 - scene.release.position[i].z);
    EXPECT_NEAR(state.pressure(scene.release.density[i]), expected, 1e-6 * 1726 * 9.81);
  }
}

TEST(PlaneScene, OnLevelGroundThePathGoesTheLongestWay) {
  PlaneWorld world;
  const Scene scene = world.make(pool);
  ASSERT_EQ(scene.path.vertices.size(), 2u);
  EXPECT_NEAR(norm(scene.path.vertices[0] - Vec3d{2, 1.5, 0}), 0, 1e-9);
  EXPECT_NEAR(norm(scene.path.vertices[1] - Vec3d{10, 1.5, 0}), 0, 1e-9);
}

TEST(PlaneScene, OnATiltedPlaneThePathGoesDown) {
  PlaneWorld world;
  const Scene scene =
      world.make(pool, "extent = [0, 0, 10, 6]\nslope = 20\ndirection = 180\nelevation = -2");
  ASSERT_TRUE(world.faults.empty()) << world.messages().front();
  EXPECT_LT(scene.path.vertices.back().y, 0.5);
  EXPECT_NEAR(scene.path.vertices.back().x, 2, 0.3);
  EXPECT_NEAR(scene.surface->height(5, 1), -2 + std::tan(20 * degree), 1e-9);
}

TEST(BodiesScene, TellsWhatTheBodiesAre) {
  PlaneWorld world;
  world.folder.write("cube.obj", unit_cube);
  const Scene scene = world.make(pool + R"(
[[body]]
name = "tank"
kind = "tank"
min = [1, 1, 0]
max = [9, 5, 1]
[[body]]
kind = "mesh"
file = "cube.obj"
frame = "local"
at = [6, 3, 0]
scale = 2
)");
  ASSERT_TRUE(world.faults.empty()) << world.messages().front();
  ASSERT_EQ(scene.bodies.size(), 2u);
  // Walls and floor of 0.3 m around 8 x 4 x 1.
  const std::string text = preview_text(world.c, scene, "");
  EXPECT_THAT(text, HasSubstr("tank: tank, a solid of 19.43 m3"));
  EXPECT_THAT(text, HasSubstr("body 2: mesh, a solid of 8 m3 and 24 m2, 12 triangles, watertight"));
  EXPECT_THAT(text, HasSubstr("2 x 2 x 2 m, from 0 to 2 m high"));
  EXPECT_THAT(preview_svg(world.c, scene), HasSubstr("body 2"));
  EXPECT_EQ(shown_mesh(world.c.bodies[1], scene.bodies[1], scene).triangles.size(), 12u);
  // Its floor is the ground.
  EXPECT_EQ(shown_mesh(world.c.bodies[0], scene.bodies[0], scene).triangles.size(), 10u);
}

TEST(BodiesScene, TheReleaseLeavesThemOut) {
  PlaneWorld world;
  const Scene scene =
      world.make(pool + "[[body]]\nkind = \"box\"\nmin = [2, 1, 0]\nmax = [2.5, 1.5, 2]\n");
  EXPECT_NEAR(scene.release_volume, 1 - 0.125, 1e-9);
  EXPECT_NEAR(scene.release_area, 2 - 0.25, 1e-9);
}

TEST(BodiesScene, RefusesOneInTheGround) {
  PlaneWorld world;
  world.make(pool + "[[body]]\nkind = \"box\"\nmin = [5, 1, -3]\nmax = [6, 1.5, -1]\n");
  EXPECT_THAT(world.messages(), ElementsAre(HasSubstr("body[1]: \"")));
  EXPECT_THAT(world.messages(), ElementsAre(HasSubstr("has no part above the ground")));
}

TEST(BodiesScene, AnOpenMeshNamesAnEdgeInTheCoordinatesOfTheFile) {
  PlaneWorld world;
  world.folder.write("open.obj", unit_cube.substr(0, unit_cube.find("f 4 1 5 8")));
  world.make(
      "[release]\nbox = [1001, 2001, 0, 1003, 2002, 0.5]\n"
      "[[body]]\nkind = \"mesh\"\nfile = \"open.obj\"\nat = [1000, 2000, 0]\n",
      "extent = [1000, 2000, 1010, 2006]");
  ASSERT_EQ(world.messages().size(), 1u);
  EXPECT_THAT(world.messages().front(), HasSubstr("is not watertight: 4 edges"));
  EXPECT_THAT(world.messages().front(), HasSubstr("(1000."));
}

TEST(BodiesScene, RefusesMeshesThatEncloseNothingOrLieFarAway) {
  const auto fault = [](const std::string& obj, const std::string& keys) {
    PlaneWorld world;
    world.folder.write("a.obj", obj);
    world.make(pool + "[[body]]\nkind = \"mesh\"\nfile = \"a.obj\"\n" + keys);
    return world.messages().empty() ? std::string() : world.messages().front();
  };
  EXPECT_THAT(fault("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 3\n", ""),
              HasSubstr("encloses no volume"));
  EXPECT_THAT(fault("v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3\n", ""), HasSubstr("encloses no volume"));
  EXPECT_THAT(fault(unit_cube, "at = [1e8, 0, 0]\n"), HasSubstr("beyond 1e+08 m"));
  EXPECT_EQ(fault(unit_cube, "at = [5, 5, 0]\n"), "");
}

TEST(BodiesScene, RefusesSinglePrecisionAtCoordinatesOfAMap) {
  // Sides of 16 m at 3.13 million m north, whole numbers that single precision holds.
  std::string obj;
  for (const double z : {0, 16})
    for (const auto& [x, y] : {std::pair{0, 0}, {16, 0}, {16, 16}, {0, 16}})
      obj += "v " + std::to_string(350000 + x) + " " + std::to_string(3130000 + y) + " " +
             std::to_string(z) + "\n";
  obj += unit_cube.substr(unit_cube.find('f'));
  PlaneWorld world;
  world.folder.write("a.obj", obj);
  world.make(
      "[release]\nbox = [350100, 3130001, 0, 350103, 3130002, 0.5]\n"
      "[[body]]\nkind = \"mesh\"\nfile = \"a.obj\"\n",
      "extent = [350000, 3130000, 350120, 3130030]\ncell_size = 1");
  EXPECT_THAT(world.messages(), ElementsAre(HasSubstr("is in single precision")));
}

TEST(LabTemplates, AreReadWithoutAFault) {
  for (const char* name : {"dam-break", "flume"}) {
    const TemporaryFolder folder;
    new_case(name, folder / "case");
    Faults faults;
    const Case c = read_case(folder / "case", faults);
    const Scene scene = make_scene(c, faults);
    for (const Fault& fault : faults.list()) ADD_FAILURE() << name << ": " << to_string(fault);
    EXPECT_GT(scene.release.size(), 2000u) << name;
    EXPECT_LT(scene.release.size(), 20000u) << name;
  }
}

TEST(LabTemplates, ADamBreakLeavesItsBodiesAndPictures) {
  const TemporaryFolder folder;
  new_case("dam-break", folder / "case");
  Faults faults;
  Case c = read_case(folder / "case", faults);
  c.numerics.spacing = 0.1;
  c.run.duration = 0.1;
  RunOptions options;
  options.folder = folder / "run";
  EXPECT_EQ(run_case(c, options).end, RunEnd::finished);
  EXPECT_TRUE(std::filesystem::exists(folder / "run/frames/bodies.vtp"));
  EXPECT_THAT(folder.read("run/pictures/deposit.svg"), HasSubstr(">tank</text>"));
  draw_states(folder / "run", {0.1});
  EXPECT_THAT(folder.read("run/states.html"), HasSubstr("state_depth"));
}

}  // namespace
}  // namespace sabo
