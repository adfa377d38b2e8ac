#include "io/mesh/read_mesh.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "geometry/mesh_topology.hpp"
#include "support/fault_of.hpp"
#include "support/temporary_folder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sabo {
namespace {

using testing::HasSubstr;

/// Corners (0,0,0), (1,0,0), (0,2,0), (0,0,3): a volume of 1.
const char* const tetrahedron_obj = R"(# by hand
mtllib none.mtl
o tetrahedron
v 0 0 0
v 1 0 0 0.5 0.5 0.5
v 0 2. 0
v +0 0 3e0
vt 0 0
vn 0 0 1
f 1 3 2
f 1/1 2/1 4/1
f -4//1 -1//1 -2//1
f 2/1/1 3/1/1 \
  4/1/1  # the last
)";

std::string facet(const char* a, const char* b, const char* c) {
  return std::string(" facet normal 0 0 0\n  outer loop\n   vertex ") + a + "\n   vertex " + b +
         "\n   vertex " + c + "\n  endloop\n endfacet\n";
}

std::string tetrahedron_stl() {
  return "solid by hand: 1\n" + facet("0 0 0", "0 2 0", "1 0 0") +
         facet("0 0 0", "1 0 0", "0 0 3") + facet("0 0 0", "0 0 3", "0 2 0") +
         facet("1 0 0", "0 2 0", "0 0 3") + "endsolid by hand: 1\n";
}

std::string binary_stl(const std::vector<std::array<float, 9>>& triangles) {
  std::string bytes(80, ' ');
  const auto add = [&bytes](std::uint32_t value) {
    for (int k = 0; k < 4; ++k) bytes += static_cast<char>(value >> 8 * k & 0xff);
  };
  add(static_cast<std::uint32_t>(triangles.size()));
  for (const auto& numbers : triangles) {
    for (int k = 0; k < 3; ++k) add(0);
    for (const float number : numbers) add(std::bit_cast<std::uint32_t>(number));
    bytes += std::string(2, '\0');
  }
  return bytes;
}

const std::vector<std::array<float, 9>> tetrahedron{{0, 0, 0, 0, 2, 0, 1, 0, 0},
                                                    {0, 0, 0, 1, 0, 0, 0, 0, 3},
                                                    {0, 0, 0, 0, 0, 3, 0, 2, 0},
                                                    {1, 0, 0, 0, 2, 0, 0, 0, 3}};

void expect_tetrahedron(TriangleMesh mesh) {
  EXPECT_EQ(mesh.triangles.size(), 4u);
  mesh = welded(mesh, 1e-9);
  EXPECT_EQ(mesh.vertices.size(), 4u);
  EXPECT_TRUE(orient_outwards(mesh).is_watertight());
  EXPECT_NEAR(volume(mesh), 1, 1e-12);
}

Fault stl_fault(const std::string& bytes) {
  return fault_of([&] { parse_stl(bytes, "a.stl", "body[1].file"); });
}

Fault obj_fault(const std::string& text) {
  return fault_of([&] { parse_obj(text, "a.obj", "body[1].file"); });
}

TEST(ReadMesh, AFileOfEachKind) {
  const TemporaryFolder folder;
  expect_tetrahedron(read_mesh(folder.write("a.obj", tetrahedron_obj), "key"));
  expect_tetrahedron(read_mesh(folder.write("a.stl", tetrahedron_stl()), "key"));
  expect_tetrahedron(read_mesh(folder.write("b.STL", binary_stl(tetrahedron)), "key"));
}

TEST(ReadMesh, RefusesOtherNamesAndWhatIsNoFile) {
  const TemporaryFolder folder;
  const auto fault = [&](const std::filesystem::path& file) {
    return fault_of([&] { read_mesh(file, "body[1].file"); });
  };
  EXPECT_EQ(fault(folder.write("a.ply", "ply")).place, "body[1].file");
  EXPECT_THAT(fault(folder / "a.ply").remedy, HasSubstr(".stl or .obj"));
  EXPECT_THAT(fault(folder.write("a.stl", "")).problem, HasSubstr("is empty"));
  std::filesystem::create_directory(folder / "b.obj");
  EXPECT_THAT(fault(folder / "b.obj").problem, HasSubstr("cannot be read"));
}

TEST(ParseStl, AsciiMayBeInCapitalsAndHoldTwoSolids) {
  std::string capitals = tetrahedron_stl();
  for (char& c : capitals) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  expect_tetrahedron(parse_stl(capitals, "", ""));
  EXPECT_EQ(parse_stl(capitals + tetrahedron_stl(), "", "").triangles.size(), 8u);
}

TEST(ParseStl, BinaryMayBeginWithSolid) {
  std::string bytes = binary_stl(tetrahedron);
  bytes.replace(0, 5, "solid");
  expect_tetrahedron(parse_stl(bytes, "", ""));
}

TEST(ParseStl, NamesTheLineAndTheWord) {
  std::string text = tetrahedron_stl();
  const Fault number = stl_fault(text.replace(text.find("0 2 0"), 5, "0 x 0"));
  EXPECT_EQ(number.place, "body[1].file");
  EXPECT_EQ(number.problem, "a.stl, line 5: \"x\" where \"a number\" is wanted");
  text = tetrahedron_stl();
  EXPECT_THAT(stl_fault(text.replace(text.find("outer"), 5, "inner")).problem,
              HasSubstr("line 3: \"inner\" where \"outer\""));
  text = tetrahedron_stl();
  EXPECT_THAT(stl_fault(text.substr(0, text.find("endloop"))).problem,
              HasSubstr("it ends where \"endloop\""));
  EXPECT_THAT(stl_fault("solid\nendsolid\n").problem, HasSubstr("has no triangles"));
  EXPECT_THAT(stl_fault("solid\n" + facet("nan 0 0", "0 0 0", "1 1 1")).problem,
              HasSubstr("\"nan\""));
  EXPECT_THAT(stl_fault("solid\n" + facet("1e999 0 0", "0 0 0", "1 1 1")).problem,
              HasSubstr("\"1e999\""));
}

TEST(ParseStl, RefusesABinaryFileOfAnotherSize) {
  const std::string bytes = binary_stl(tetrahedron);
  EXPECT_THAT(stl_fault(bytes.substr(0, bytes.size() - 1)).problem,
              HasSubstr("its 4 triangles would take 284 bytes, it has 283"));
  std::string claims = bytes;
  claims.replace(80, 4, "\xff\xff\xff\xff");  // four thousand million triangles
  EXPECT_THAT(stl_fault(claims).problem, HasSubstr("4294967295 triangles"));
  EXPECT_THAT(stl_fault("short").problem, HasSubstr("too short"));
}

TEST(ParseStl, NamesTheTriangleThatIsNotFinite) {
  auto triangles = tetrahedron;
  triangles[2][4] = std::numeric_limits<float>::infinity();
  EXPECT_THAT(stl_fault(binary_stl(triangles)).problem, HasSubstr("triangle 3"));
  triangles[2][4] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THAT(stl_fault(binary_stl(triangles)).problem, HasSubstr("not finite"));
}

TEST(ParseObj, CutsFacesOfManyCorners) {
  const TriangleMesh mesh =
      parse_obj("v 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 1 0\nf 1 2 3 4 5\n", "", "");
  EXPECT_EQ(mesh.triangles.size(), 3u);
  EXPECT_NEAR(area(mesh), 2.5, 1e-12);  // of the pentagon, by the shoelace formula
}

TEST(ParseObj, NamesTheLineOfAFault) {
  EXPECT_EQ(obj_fault("v 0 0 0\nv 0 1\n").problem,
            "a.obj, line 2: a vertex has fewer than three numbers");
  EXPECT_THAT(obj_fault("v 0 0 z\n").problem, HasSubstr("line 1: \"z\" is not a number"));
  EXPECT_THAT(obj_fault("v 0 0 0\n\nf 1 2 3\n").problem,
              HasSubstr("line 3: there is no vertex 2 among the 1"));
  EXPECT_THAT(obj_fault("v 0 0 0\nf -2 1 1\n").problem, HasSubstr("no vertex -2"));
  EXPECT_THAT(obj_fault("v 0 0 0\nf 0 1 1\n").problem, HasSubstr("no vertex 0"));
  EXPECT_THAT(obj_fault("v 0 0 0\nf 1 1\n").problem, HasSubstr("fewer than three vertices"));
  EXPECT_THAT(obj_fault("v 0 0 0\nf 1 /1 1\n").problem, HasSubstr("\"/1\" is not the number"));
  EXPECT_THAT(obj_fault("v 0 0 0\nf 99999999999999999999 1 1\n").problem,
              HasSubstr("is not the number"));
  EXPECT_THAT(obj_fault("garbage \x01\x02\n").problem, HasSubstr("has no faces"));
}

TEST(ParseObj, ReadsLinesThatEndAsOnWindows) {
  const TriangleMesh mesh = parse_obj("v 0 0 0\r\nv 1 0 0\r\nv 0 1e-400 1\r\nf 1 2 3\r\n", "", "");
  EXPECT_EQ(mesh.triangles.size(), 1u);
  EXPECT_EQ(mesh.vertices[2], (Vec3d{0, 0, 1}));
}

}  // namespace
}  // namespace sabo
