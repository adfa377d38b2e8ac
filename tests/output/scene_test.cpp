#include <cmath>

#include "geometry/box_mesh.hpp"
#include "support/fault_of.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/output/scene_bodies.hpp"
#include "io/output/scene_overlay.hpp"
#include "io/output/scene_picture.hpp"
#include "io/output/scene_shading.hpp"
#include "terrain/dam_mesh.hpp"
#include "terrain/valley.hpp"

namespace sabo {
namespace {

using testing::HasSubstr;
using testing::Not;

// 40 x 40 m of flat ground at 5 m, the south-west corner at (0, 0).
const Grid field{.columns = 40, .rows = 40, .west = 0, .north = 40};
const MapView whole_field{0, 0, 40, 40};

TEST(SceneMesh, LiftsTheGroundByTheDepthAboveTheThreshold) {
  const Raster ground(field, 5);
  Raster depth(field, 0.04), speed(field, Raster::no_data);
  depth.at(10, 20) = 2;
  speed.at(10, 20) = 7;
  const SceneMesh mesh = scene_mesh({ground, depth, speed, 0.05}, whole_field, 10'000, 1);
  ASSERT_EQ(mesh.columns(), 40);
  EXPECT_TRUE(mesh.at(10, 20).is_wet);
  EXPECT_EQ(mesh.at(10, 20).z, 7);
  EXPECT_EQ(mesh.at(10, 20).elevation, 5);
  EXPECT_EQ(mesh.at(10, 20).value, 7);
  EXPECT_FALSE(mesh.at(11, 20).is_wet);
  EXPECT_EQ(mesh.at(11, 20).z, 5);
  EXPECT_EQ(mesh.at(11, 20).value, 7);  // so that the colour reaches the edge of the flow
  EXPECT_EQ(mesh.at(12, 20).value, 0);
  // Cell 10 from the west and 20 from the north has its centre at (10.5, 19.5).
  EXPECT_DOUBLE_EQ(mesh.height(10.5, 19.5), 7);
  EXPECT_DOUBLE_EQ(mesh.height(10.75, 19.5), 6.5);
  EXPECT_TRUE(std::isnan(mesh.height(0.4, 19.5)));
}

TEST(SceneMesh, ThinningKeepsTheFlowOfOneCell) {
  Raster ground(field, 5);
  Raster depth(field), speed(field, 1);
  depth.at(17, 33) = 2;
  speed.at(17, 33) = 7;
  depth.at(18, 34) = 1;  // shallower, and later in the order of the cells
  ground.at(16, 33) = 9;
  // 16 corners for 1600 cells: each stands for 10 x 10 of them.
  const SceneMesh mesh = scene_mesh({ground, depth, speed, 0.05}, whole_field, 16, 1);
  ASSERT_EQ(mesh.columns(), 4);
  ASSERT_EQ(mesh.rows(), 4);
  EXPECT_DOUBLE_EQ(mesh.x[1], 15);
  EXPECT_DOUBLE_EQ(mesh.y[3], 5);
  EXPECT_TRUE(mesh.at(1, 3).is_wet);
  EXPECT_EQ(mesh.at(1, 3).value, 7);
  EXPECT_DOUBLE_EQ(mesh.at(1, 3).z, 5 + 4.0 / 100 + 2);  // mean ground and greatest depth
  EXPECT_FALSE(mesh.at(2, 3).is_wet);
}

TEST(SceneMesh, RefusesRastersOfDifferentGrids) {
  const Raster ground(field, 5), other(Grid{.columns = 40, .rows = 39, .north = 40});
  EXPECT_THAT(run_error_of([&] {
                scene_mesh({ground, other, ground, 0}, whole_field, 10, 1);
              }),
              HasSubstr("different grids"));
}

TEST(SceneMesh, ASlopeTowardsTheLightIsBright) {
  Raster ground(field), none(field);
  for (int row = 0; row < 40; ++row) {
    for (int column = 0; column < 40; ++column) ground.at(column, row) = column;  // faces west
  }
  SceneMesh mesh = scene_mesh({ground, none, none, 0.05}, whole_field, 10'000, 1);
  light_mesh(mesh, normalised(Vec3d{-1, 0, 1}));
  EXPECT_NEAR(mesh.at(20, 20).shade, 1, 1e-6);
  light_mesh(mesh, normalised(Vec3d{1, 0, 1}));
  EXPECT_NEAR(mesh.at(20, 20).shade, 0.5, 1e-6);
}

// A canvas on which the field is seen from the south, 45 degrees down, one sample for a pixel.
class FieldScene : public testing::Test {
 protected:
  FieldScene()
      : mesh_(scene_mesh({ground_, depth_, depth_, 0.05}, whole_field, 10'000, 1)),
        view_{camera_around(points_to_show(mesh_), {0, 45}, 600, 400, 1)},
        canvas_(600, 400) {
    light_mesh(mesh_, {0, 0, 1});
    draw_mesh(canvas_, mesh_, view_);
  }
  // A wall from west to east, 10 m high, 2 m thick, its axis at y = 20.
  void build_wall() { draw_body(canvas_, wall_, mesh_, view_, {0, 0, 1}); }
  ScenePage page() const { return {mesh_, canvas_, view_, 0, 0, 600, 400}; }
  const CanvasSample& sample_at(const Vec3d& point) const {
    const CanvasCorner corner = view_.corner(point);
    return canvas_.at(static_cast<int>(corner.x), static_cast<int>(corner.y));
  }

  Raster ground_{field, 5};
  Raster depth_{field};
  SceneMesh mesh_;
  CanvasView view_;
  DepthCanvas canvas_;
  SceneBody wall_{"wall", box_mesh({{5, 19, 3}, {35, 21, 15}, {}, 0})};
};

TEST_F(FieldScene, AWallHidesWhatIsBehindIt) {
  // Its top hides the ground behind it as far as it is high, since one looks 45 degrees down: at
  // the middle of the picture, where the perspective changes little.
  EXPECT_EQ(sample_at({20, 24, 5}).shown, Shown::ground);
  EXPECT_TRUE(page_point(page(), {20, 24, 5}).is_seen);
  build_wall();
  EXPECT_EQ(sample_at({20, 24, 5}).shown, Shown::wall);
  EXPECT_FALSE(page_point(page(), {20, 24, 5}).is_seen);
  EXPECT_EQ(sample_at({20, 14, 5}).shown, Shown::ground);
  EXPECT_TRUE(page_point(page(), {20, 14, 5}).is_seen);
  EXPECT_TRUE(page_point(page(), {20, 20, 15}).is_seen);
}

TEST_F(FieldScene, LinesBehindAWallAreLeftOut) {
  build_wall();
  SceneLabels labels(page());
  const MapLine behind{MapLine::Kind::section, "behind", {{{10, 25, 0}, {30, 25, 0}}, false}};
  const MapLine before{MapLine::Kind::section, "before", {{{10, 10, 0}, {30, 10, 0}}, false}};
  EXPECT_EQ(draw_draped(page(), behind, labels), "");
  EXPECT_THAT(draw_draped(page(), before, labels), HasSubstr("<path d=\"M"));
  label_body(page(), wall_, labels);
  EXPECT_THAT(labels.svg(), Not(HasSubstr(">behind<")));
  EXPECT_THAT(labels.svg(), HasSubstr(">before<"));
  EXPECT_THAT(labels.svg(), HasSubstr(">wall<"));
}

TEST_F(FieldScene, LabelsKeepOffEachOther) {
  SceneLabels labels(page());
  const PagePoint place{300, 200, true};
  labels.add("one", "#000000", {place});
  labels.add("two", "#000000", {place});
  EXPECT_THAT(labels.svg(), HasSubstr("y=\"191.0\" font-size=\"13\" fill=\"#000000\""));
  EXPECT_THAT(labels.svg(), HasSubstr("y=\"168.0\" font-size=\"13\" fill=\"#000000\""));
  const std::string before = labels.svg();
  labels.add("hidden", "#000000", {{100, 200, false}});
  labels.add("outside", "#000000", {{100, 1, true}});
  EXPECT_EQ(labels.svg(), before);
}

TEST(SceneShading, GroundIsGreyFlowColouredAndWallsRed) {
  DepthCanvas canvas(6, 2);
  const auto draw = [&canvas](double left, Shown shown) {
    const CanvasCorner a{.x = left, .y = -5, .nearness = 1, .value = 1};
    const CanvasCorner b{.x = left, .y = 9, .nearness = 1, .value = 1};
    const CanvasCorner c{.x = left + 9, .y = 2, .nearness = 1, .value = 1};
    canvas.draw_solid(a, b, c, shown);
  };
  // The nearest of equals is the first: two columns each, from right to left.
  draw(4, Shown::wall);
  draw(2, Shown::flow);
  draw(0, Shown::ground);
  const Image image = shaded(canvas, {.top = 1, .contour = 10});
  ASSERT_EQ(image.pixels.size(), 3u);
  const Colour ground = image.pixels[0], flow = image.pixels[1], wall = image.pixels[2];
  EXPECT_EQ(ground[0], ground[1]);
  EXPECT_EQ(ground[0], ground[2]);
  EXPECT_GT(flow[2], flow[1] + 30);  // the dark end of the scale is violet
  EXPECT_GT(wall[0], wall[2] + 30);
}

TEST(ChooseDirection, LooksSteeplyIntoAGorge) {
  // Flow from west to east on a floor of 20 m, looked at across it. Sides of 2 m hide 3 m of the
  // floor at 35 degrees; sides of 60 m hide all of it below 71 degrees.
  for (const double height : {2.0, 60.0}) {
    Raster ground(Grid{.columns = 100, .rows = 60, .north = 60}, height), depth(ground.grid);
    for (int row = 20; row < 40; ++row) {
      for (int column = 0; column < 100; ++column) {
        ground.at(column, row) = 0;
        if (row >= 24 && row < 36) depth.at(column, row) = 0.5;
      }
    }
    const SceneMesh mesh = scene_mesh({ground, depth, depth, 0.05}, {0, 0, 100, 60}, 10'000, 1);
    EXPECT_EQ(choose_direction(mesh, {.azimuth = 0}).down, height < 10 ? 35 : 65) << height;
  }
}

TEST_F(FieldScene, ABodyIsSeenFromOutside) {
  const SceneBody body{"house", box_mesh({{10, 15, 4}, {30, 25, 10}, {}, 0})};
  draw_body(canvas_, body, mesh_, view_, {0, 0, 1});
  EXPECT_EQ(sample_at({20, 15, 7.5}).shown, Shown::wall);  // the near side
  EXPECT_EQ(sample_at({20, 20, 10}).shown, Shown::wall);   // its top
  EXPECT_GT(sample_at({20, 20, 10}).shade, sample_at({20, 15, 7.5}).shade);
  EXPECT_EQ(sample_at({20, 5, 5}).shown, Shown::ground);
  SceneLabels labels(page());
  label_body(page(), body, labels);
  EXPECT_THAT(labels.svg(), HasSubstr(">house</text>"));
}

TEST_F(FieldScene, ATankIsSeenInto) {
  SceneBody tank{"", box_mesh({{10, 15, 5}, {30, 25, 10}, {}, 0}), false};
  std::erase_if(tank.mesh.triangles, [&](const Triangle& t) {
    return tank.mesh.vertices[t[0]].z + tank.mesh.vertices[t[1]].z + tank.mesh.vertices[t[2]].z ==
           15;  // its floor
  });
  for (Triangle& t : tank.mesh.triangles) std::swap(t[1], t[2]);
  draw_body(canvas_, tank, mesh_, view_, {0, 0, 1});
  EXPECT_EQ(sample_at({20, 15, 7.5}).shown, Shown::ground);  // through its near side
  EXPECT_EQ(sample_at({20, 25, 7.5}).shown, Shown::wall);    // the inside of its far side
}

TEST(SceneBodies, AreCutAtTheEdgesOfTheView) {
  SceneBody box{"", box_mesh({{0, 0, 0}, {4, 2, 1}, {}, 0})};
  // From x = 1 to 3 and y = 0 to 1, a closed box again.
  const TriangleMesh part = within({1, -1, 3, 1}, box).mesh;
  EXPECT_NEAR(area(part), 2 * (2 + 2 + 1), 1e-12);
  EXPECT_NEAR(volume(part), 2, 1e-12);
  EXPECT_NEAR(area(within({-1, -1, 9, 9}, box).mesh), area(box.mesh), 1e-12);
  EXPECT_EQ(within({5, 0, 9, 9}, box).mesh.triangles.size(), 0u);
  // A hollow has floor and top, and the side at y = 0 between them.
  box.is_solid = false;
  EXPECT_NEAR(area(within({1, -1, 3, 1}, box).mesh), 2 + 2 + 2, 1e-12);
}

TEST(SceneBodies, EachPartOfACutIsClosed) {
  // A U of three boxes, cut through its two arms.
  SceneBody body{"", box_mesh({{0, 0, 0}, {3, 1, 1}, {}, 0})};
  append(body.mesh, box_mesh({{0, 1, 0}, {1, 4, 1}, {}, 0}));
  append(body.mesh, box_mesh({{2, 1, 0}, {3, 4, 1}, {}, 0}));
  EXPECT_NEAR(volume(within({-1, -1, 9, 2}, body).mesh), 3 + 1 + 1, 1e-12);
}

// The text of a picture without its pixels.
std::string text_of(const std::string& svg) {
  const std::size_t begin = svg.find("base64,");
  const std::size_t end = svg.find('"', begin);
  EXPECT_NE(begin, svg.npos);
  return svg.substr(0, begin) + svg.substr(end);
}

ScenePicture valley_scene() {
  ScenePicture scene{.title = "Flow & dam", .quantity = "depth [m]", .threshold = 0.05};
  scene.view = {0, -80, 1200, 80};
  scene.bodies = {{"dam", dam_mesh(valley_dam(), Surface(valley_dem(5)), 5)}};
  scene.lines = {{MapLine::Kind::path, "", valley_path()}};
  return scene;
}

TEST(Scene, AValleyIsSeenUpwards) {
  const Raster ground = valley_dem(5);
  Raster depth(ground.grid);
  for (int column = 20; column < 60; ++column) depth.at(column, depth.grid.rows / 2) = 2;
  ScenePicture scene = valley_scene();
  const LookDirection direction = scene_direction(scene, ground, depth);
  // The valley falls from west to east: up is west, 270 degrees, give or take the turns of 60.
  EXPECT_GE(direction.azimuth, 209);
  EXPECT_LE(direction.azimuth, 331);
  scene.azimuth = 270;
  scene.down = 30;
  scene.exaggeration = 2;
  const std::string text = text_of(scene_svg(scene, ground, depth, depth));
  EXPECT_THAT(text, HasSubstr(">Flow &amp; dam</text>"));
  EXPECT_THAT(text, HasSubstr(">depth [m]</text>"));
  EXPECT_THAT(text, HasSubstr(">dam</text>"));  // 320 m below the flow
  EXPECT_THAT(text, HasSubstr("looking W (270°), 30° down"));
  EXPECT_THAT(text, HasSubstr("heights × 2"));
}

// A picture of a ground with or without flow; fails when its text holds what is no number.
void expect_picture(const Raster& ground, double depth, const MapView& view) {
  ScenePicture scene = valley_scene();
  scene.view = view;
  Raster flow(ground.grid, depth);
  flow.values.front() = HUGE_VAL;
  const std::string text = text_of(scene_svg(scene, ground, flow, flow));
  for (const char* odd : {"\"nan", " nan", ">nan", "Mnan", "Lnan", "\"inf", " inf", ">inf"})
    EXPECT_EQ(text.find(odd), std::string::npos) << odd;
  EXPECT_THAT(text, HasSubstr("</svg>"));
}

TEST(Scene, OneCellAndAStripArePictures) {
  expect_picture(Raster(Grid{.columns = 1, .rows = 1, .north = 1}, 5), 1, {0, 0, 1, 1});
  expect_picture(Raster(Grid{.columns = 1, .rows = 50, .north = 50}, 5), 1, {0, 0, 1, 50});
}

TEST(Scene, HolesAndAWindowBesideTheGroundArePictures) {
  Raster rough(field, 5);
  rough.at(3, 3) = HUGE_VAL;
  rough.at(4, 4) = Raster::no_data;
  expect_picture(rough, 0, {0, 0, 40, 40});
  expect_picture(rough, 1, {100, 100, 200, 200});
  expect_picture(Raster(field, Raster::no_data), 1, {5, 5, 5, 5});
}

}  // namespace
}  // namespace sabo
