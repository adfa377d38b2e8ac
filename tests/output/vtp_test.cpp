#include "io/output/vtp.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "support/fault_of.hpp"
#include "support/temporary_folder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

namespace sabo {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

// Reads arrays back as VTK does: the offset in the element, a UInt64 header, zlib blocks.
class VtpReader {
 public:
  explicit VtpReader(std::string text) : text_(std::move(text)) {
    appended_ = text_.find("<AppendedData encoding=\"raw\">\n_");
    EXPECT_NE(appended_, std::string::npos);
    appended_ += std::strlen("<AppendedData encoding=\"raw\">\n_");
  }

  template <class T>
  std::vector<T> array(const std::string& name) const {
    const std::size_t element = text_.find("Name=\"" + name + "\"");
    const std::size_t offset = text_.find("offset=\"", element);
    if (element == std::string::npos || offset == std::string::npos) return {};
    const char* place = text_.data() + appended_ + std::stoul(text_.substr(offset + 8));
    const std::uint64_t blocks = take(place), size = take(place), last = take(place);
    std::vector<std::uint64_t> packed(blocks);
    for (std::uint64_t& bytes : packed) bytes = take(place);
    std::vector<Bytef> all;
    for (std::size_t i = 0; i < blocks; ++i) {
      std::vector<Bytef> block(i + 1 == blocks && last > 0 ? last : size);
      uLongf count = block.size();
      EXPECT_EQ(uncompress(block.data(), &count, reinterpret_cast<const Bytef*>(place), packed[i]),
                Z_OK);
      EXPECT_EQ(count, block.size());
      all.insert(all.end(), block.begin(), block.end());
      place += packed[i];
    }
    std::vector<T> values(all.size() / sizeof(T));
    if (!all.empty()) std::memcpy(values.data(), all.data(), all.size());
    return values;
  }

  const std::string& text() const { return text_; }

 private:
  static std::uint64_t take(const char*& place) {
    std::uint64_t value = 0;
    std::memcpy(&value, place, sizeof value);
    place += sizeof value;
    return value;
  }

  std::string text_;
  std::size_t appended_ = 0;
};

class Vtp : public testing::Test {
 protected:
  VtpReader written(const VtpFrame& frame) {
    write_particles_vtp(folder_ / "f.vtp", frame);
    return VtpReader(folder_.read("f.vtp"));
  }
  TemporaryFolder folder_;
};

TEST_F(Vtp, ParticlesComeBackAsWritten) {
  const std::vector<Vec3f> points{{1, 2, 3}, {4, 5, 6}};
  const std::vector<float> pressure{10.5f, -20};
  const std::vector<float> velocity{1, 0, 0, 0, 1, 0};
  const std::vector<std::uint32_t> id{7, 4'000'000'000};
  const VtpReader file = written({.time = 2.5,
                                  .origin = {618000, 3996000, 0},
                                  .points = points,
                                  .arrays = {{"pressure [Pa]", 1, std::span(pressure)},
                                             {"velocity [m/s]", 3, std::span(velocity)},
                                             {"id", 1, std::span(id)}}});
  EXPECT_THAT(file.array<float>("position [m]"), ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_EQ(file.array<float>("pressure [Pa]"), pressure);
  EXPECT_EQ(file.array<float>("velocity [m/s]"), velocity);
  EXPECT_EQ(file.array<std::uint32_t>("id"), id);
  EXPECT_THAT(file.array<std::int32_t>("connectivity"), ElementsAre(0, 1));
  EXPECT_THAT(file.array<std::int32_t>("offsets"), ElementsAre(1, 2));
  EXPECT_THAT(file.text(), HasSubstr("NumberOfPoints=\"2\" NumberOfVerts=\"2\""));
  EXPECT_THAT(file.text(), HasSubstr("format=\"ascii\">2.5</DataArray>"));
  EXPECT_THAT(file.text(), HasSubstr("format=\"ascii\">618000 3996000 0</DataArray>"));
}

TEST_F(Vtp, LargeArraysGoOverSeveralBlocks) {
  const std::size_t full = 2 * (1 << 18) / sizeof(float);  // exactly two blocks
  for (const std::size_t count : {full, full + 1}) {
    std::vector<float> values(count);
    for (std::size_t i = 0; i < count; ++i) values[i] = std::sin(static_cast<float>(i));
    const std::vector<Vec3f> points(count);
    const VtpReader file = written({.points = points, .arrays = {{"a", 1, std::span(values)}}});
    EXPECT_EQ(file.array<float>("a"), values);
    write_particles_vtp(folder_ / "three.vtp",
                        {.points = points, .arrays = {{"a", 1, std::span(values)}}}, 3);
    EXPECT_EQ(folder_.read("three.vtp"), folder_.read("f.vtp"));
  }
}

TEST_F(Vtp, AFrameWithoutParticlesIsAFrame) {
  const VtpReader file = written({});
  EXPECT_THAT(file.text(), HasSubstr("NumberOfPoints=\"0\""));
  EXPECT_TRUE(file.array<float>("position [m]").empty());
}

TEST_F(Vtp, RefusesArraysThatDoNotFitAndValuesThatAreNotFinite) {
  const std::vector<Vec3f> points{{1, 2, 3}, {4, 5, 6}};
  VtpFrame frame;
  frame.points = points;
  const std::vector<float> three{1, 2, 3};
  frame.arrays = {{"p", 1, std::span(three)}};
  EXPECT_THAT(run_error_of([&] { written(frame); }), HasSubstr("p has 3 values for 2 points"));
  const std::vector<float> bad{1, std::numeric_limits<float>::quiet_NaN()};
  frame.arrays = {{"p", 1, std::span(bad)}};
  EXPECT_THAT(run_error_of([&] { written(frame); }), HasSubstr("p holds nan"));
  EXPECT_EQ(folder_.file_count(), 0u);
}

TEST_F(Vtp, SurfaceIsCutFromNorthWestToSouthEast) {
  Raster ground(Grid{.columns = 3, .rows = 2, .west = 0, .north = 20, .dx = 10, .dy = 10});
  ground.values = {1, 2, 3, 4, 5, Raster::no_data};
  write_surface_vtp(folder_ / "g.vtp", ground, {});
  const VtpReader file(folder_.read("g.vtp"));
  EXPECT_THAT(file.array<float>("position [m]"),
              ElementsAre(5, 15, 1, 15, 15, 2, 25, 15, 3, 5, 5, 4, 15, 5, 5));
  // The first square has both triangles; the second has its south-east corner in neither.
  EXPECT_THAT(file.array<std::int32_t>("connectivity"), ElementsAre(0, 3, 4, 0, 4, 1));
  EXPECT_THAT(file.array<std::int32_t>("offsets"), ElementsAre(3, 6));
}

TEST_F(Vtp, SurfaceIsThinnedToTheNumberOfPoints) {
  const Raster ground(Grid{.columns = 100, .rows = 50}, 1);
  write_surface_vtp(folder_ / "g.vtp", ground, {}, 1250);
  EXPECT_EQ(VtpReader(folder_.read("g.vtp")).array<float>("elevation [m]").size(), 1250u);
}

TEST_F(Vtp, MeshHasItsTrianglesAndNumbers) {
  const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}}, {{0, 2, 1}, {0, 1, 3}}};
  write_mesh_vtp(folder_ / "b.vtp", mesh, {1, 1, 1, 2}, {10, 20, 0});
  const VtpReader file(folder_.read("b.vtp"));
  EXPECT_THAT(file.array<float>("position [m]"), ElementsAre(0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3));
  EXPECT_THAT(file.array<float>("body"), ElementsAre(1, 1, 1, 2));
  EXPECT_THAT(file.array<std::int32_t>("connectivity"), ElementsAre(0, 2, 1, 0, 1, 3));
  EXPECT_THROW(write_mesh_vtp(folder_ / "b.vtp", mesh, {1, 1}, {}), RunError);
}

TEST_F(Vtp, MovingSurfaceHasItsTimeTrianglesAndArrays) {
  const TriangleMesh mesh{{{0, 0, 5}, {1, 0, 6}, {0, 2, 7}}, {{0, 1, 2}}};
  const std::vector<float> depth{0, 1, 2};
  write_moving_surface_vtp(folder_ / "s.vtp", {.time = 2.5,
                                               .origin = {10, 20, 0},
                                               .mesh = mesh,
                                               .arrays = {{"depth [m]", 1, std::span(depth)}}});
  const VtpReader file(folder_.read("s.vtp"));
  EXPECT_THAT(file.array<float>("position [m]"), ElementsAre(0, 0, 5, 1, 0, 6, 0, 2, 7));
  EXPECT_EQ(file.array<float>("depth [m]"), depth);
  EXPECT_THAT(file.array<std::int32_t>("connectivity"), ElementsAre(0, 1, 2));
  EXPECT_THAT(file.array<std::int32_t>("offsets"), ElementsAre(3));
  EXPECT_THAT(file.text(), HasSubstr("NumberOfPoints=\"3\" NumberOfVerts=\"0\""));
  EXPECT_THAT(file.text(), HasSubstr("NumberOfPolys=\"1\""));
  EXPECT_THAT(file.text(), HasSubstr("format=\"ascii\">2.5</DataArray>"));
  const std::vector<float> bad{0, 1, std::numeric_limits<float>::infinity()};
  EXPECT_THROW(write_moving_surface_vtp(folder_ / "s.vtp",
                                        {.mesh = mesh, .arrays = {{"a", 1, std::span(bad)}}}),
               RunError);
}

TEST_F(Vtp, ListOfFramesIsCompleteAfterEachFrame) {
  PvdWriter list(folder_ / "run.pvd");
  list.add(0, "f_0.vtp");
  EXPECT_THAT(folder_.read("run.pvd"), HasSubstr("</VTKFile>"));
  list.add(2.5, "f&1.vtp");
  const std::string text = folder_.read("run.pvd");
  EXPECT_THAT(text, StartsWith("<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\""));
  EXPECT_THAT(text, HasSubstr("<DataSet timestep=\"0\" file=\"f_0.vtp\"/>\n"
                              "<DataSet timestep=\"2.5\" file=\"f&amp;1.vtp\"/>\n"));
}

}  // namespace
}  // namespace sabo
