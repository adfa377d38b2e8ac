#include "io/output/read_vtp.hpp"

#include <cmath>
#include <cstring>
#include <limits>

#include "support/fault_of.hpp"
#include "support/temporary_folder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/output/vtp.hpp"

namespace sabo {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class ReadVtp : public testing::Test {
 protected:
  // Two particles with three arrays.
  std::string frame_bytes() {
    const std::vector<Vec3f> points{{1, 2, 3}, {4, 5, 6}};
    const std::vector<float> pressure{10.5f, -20};
    const std::vector<float> velocity{1, 0, 0, 0, 1, 0};
    const std::vector<std::uint32_t> id{7, 1 << 24};
    write_particles_vtp(folder_ / "f.vtp", {.time = 2.5,
                                            .origin = {618000, 3996000, 0},
                                            .points = points,
                                            .arrays = {{"pressure [Pa]", 1, std::span(pressure)},
                                                       {"a<b [m/s]", 3, std::span(velocity)},
                                                       {"id", 1, std::span(id)}}});
    return folder_.read("f.vtp");
  }

  std::string problem_of(const std::string& bytes) {
    const Fault fault = fault_of([&] { parse_particles_vtp(bytes, "x.vtp"); });
    EXPECT_EQ(fault.place, "x.vtp");
    EXPECT_THAT(fault.remedy, HasSubstr("run the case again"));
    return fault.problem;
  }

  // The frame with one piece of its text replaced by another.
  std::string changed(const std::string& from, const std::string& to) {
    std::string bytes = frame_bytes();
    const std::size_t place = bytes.find(from);
    EXPECT_NE(place, bytes.npos) << from;
    return bytes.replace(place, from.size(), to);
  }

  // The frame with the k-th UInt64 in front of the positions replaced: 0 number of blocks, 1 block
  // size, 2 size of the last block, 3 packed size.
  std::string with_header(std::size_t k, std::uint64_t value) {
    std::string bytes = frame_bytes();
    const std::string mark = "encoding=\"raw\">\n_";
    const std::size_t place = bytes.find(mark) + mark.size() + 8 * k;
    std::memcpy(bytes.data() + place, &value, sizeof value);
    return bytes;
  }

  TemporaryFolder folder_;
};

TEST_F(ReadVtp, AFrameComesBackAsWritten) {
  frame_bytes();
  const ParticleFrame frame = read_particles_vtp(folder_ / "f.vtp");
  EXPECT_EQ(frame.time, 2.5);
  EXPECT_EQ(frame.origin, (Vec3d{618000, 3996000, 0}));
  EXPECT_THAT(frame.points, ElementsAre(Vec3f{1, 2, 3}, Vec3f{4, 5, 6}));
  ASSERT_EQ(frame.arrays.size(), 3u);
  EXPECT_THAT(frame.find("pressure [Pa]")->values, ElementsAre(10.5f, -20));
  EXPECT_EQ(frame.find("a<b [m/s]")->components, 3);
  EXPECT_THAT(frame.find("a<b [m/s]")->values, ElementsAre(1, 0, 0, 0, 1, 0));
  EXPECT_THAT(frame.find("id")->values, ElementsAre(7, 16777216));
  EXPECT_EQ(frame.find("none"), nullptr);
}

TEST_F(ReadVtp, BlocksAreJoined) {
  const std::size_t two_blocks = 2 * (1 << 18) / sizeof(float);
  for (const std::size_t count : {two_blocks, two_blocks + 1}) {
    std::vector<float> values(count);
    for (std::size_t i = 0; i < count; ++i) values[i] = std::sin(static_cast<float>(i));
    const std::vector<Vec3f> points(count, {1, 2, 3});
    write_particles_vtp(folder_ / "f.vtp",
                        {.points = points, .arrays = {{"a", 1, std::span(values)}}});
    const ParticleFrame frame = read_particles_vtp(folder_ / "f.vtp");
    EXPECT_EQ(frame.find("a")->values, values);
    EXPECT_EQ(frame.points, points);
  }
}

TEST_F(ReadVtp, AFrameWithoutParticlesIsAFrame) {
  write_particles_vtp(folder_ / "f.vtp", {.time = 1});
  const ParticleFrame frame = read_particles_vtp(folder_ / "f.vtp");
  EXPECT_EQ(frame.time, 1);
  EXPECT_TRUE(frame.points.empty());
}

TEST_F(ReadVtp, EveryTruncatedFrameIsRefused) {
  const std::string bytes = frame_bytes();
  for (std::size_t size = 0; size < bytes.size(); ++size) problem_of(bytes.substr(0, size));
}

TEST_F(ReadVtp, SaysWhatIsDamaged) {
  EXPECT_THAT(problem_of("P6 3 2 255"), HasSubstr("no appended raw data"));
  EXPECT_THAT(problem_of(changed("UInt64", "UInt32")), HasSubstr("header_type is UInt32"));
  EXPECT_THAT(problem_of(changed("type=\"PolyData\"", "type=\"ImageData\"")),
              HasSubstr("type is ImageData instead of PolyData"));
  EXPECT_THAT(problem_of(changed(">2.5<", ">nan<")), HasSubstr("no valid \"TimeValue\""));
  EXPECT_THAT(problem_of(changed(" 3996000 ", " ")), HasSubstr("no valid \"origin [m]\""));
  EXPECT_THAT(problem_of(changed("<Points>", "<Points <")), HasSubstr("its part of text"));
  EXPECT_THAT(problem_of(changed("Name=\"id\"", "")), HasSubstr("DataArray without Name"));
  EXPECT_THAT(problem_of(changed("\"Float32\" Name=\"pressure", "\"Float64\" Name=\"pressure")),
              HasSubstr("\"pressure [Pa]\" that this program does not write"));
}

TEST_F(ReadVtp, RefusesSizesThatDoNotFit) {
  const std::string count = "NumberOfPoints=\"2\"";
  const std::string no_fit = "does not have the";
  EXPECT_THAT(problem_of(changed(count, "NumberOfPoints=\"3\"")), HasSubstr(no_fit));
  EXPECT_THAT(problem_of(changed(count, "NumberOfPoints=\"2000000000\"")), HasSubstr(no_fit));
  EXPECT_THAT(problem_of(changed(count, "NumberOfPoints=\"99999999999\"")),
              HasSubstr("how many particles"));
  EXPECT_THAT(problem_of(changed(count, "NumberOfPoints=\"-2\"")), HasSubstr("how many particles"));
  EXPECT_THAT(problem_of(changed("offset=\"0\"", "offset=\"999999\"")),
              HasSubstr("has an offset of 999999"));
  constexpr std::uint64_t huge = std::numeric_limits<std::uint64_t>::max();
  for (const std::uint64_t value : {std::uint64_t{0}, std::uint64_t{7}, huge}) {
    EXPECT_THAT(problem_of(with_header(0, value)), HasSubstr(no_fit));
    EXPECT_THAT(problem_of(with_header(2, value)), HasSubstr(no_fit));
  }
  EXPECT_THAT(problem_of(with_header(3, huge)), HasSubstr("a block of 18446744073709551615 bytes"));
  EXPECT_THAT(problem_of(with_header(3, 5)), HasSubstr("block 1 of 1 is damaged"));
}

TEST_F(ReadVtp, TakesNoMemoryForBlocksThatCannotBeTrue) {
  // 2^31 - 1 particles of 12 bytes in one block of a few packed bytes: deflate makes 1032 of one.
  std::string bytes = with_header(1, 12ull * 2147483647);
  std::uint64_t last = 0;
  const std::size_t place = bytes.find("encoding=\"raw\">\n_") + 17;
  std::memcpy(bytes.data() + place + 16, &last, sizeof last);
  const std::string count = "NumberOfPoints=\"2\"";
  bytes.replace(bytes.find(count), count.size(), "NumberOfPoints=\"2147483647\"");
  EXPECT_THAT(problem_of(bytes), HasSubstr("does not fit the file"));
}

TEST_F(ReadVtp, NoChangedByteCrashesIt) {
  const std::string bytes = frame_bytes();
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string damaged = bytes;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x15);
    try {
      const ParticleFrame frame = parse_particles_vtp(damaged, "x");
      for (const ParticleArray& array : frame.arrays) {
        EXPECT_EQ(array.values.size(), frame.points.size() * array.components);
      }
    } catch (const CaseError&) {  // the usual outcome
    }
  }
}

TEST_F(ReadVtp, NamesAFileThatIsNotThere) {
  const Fault fault = fault_of([&] { read_particles_vtp(folder_ / "none.vtp"); });
  EXPECT_THAT(fault.place, HasSubstr("none.vtp"));
  EXPECT_THAT(fault.problem, HasSubstr("cannot be read"));
}

TEST_F(ReadVtp, AListComesBackAsWritten) {
  PvdWriter list(folder_ / "flow.pvd");
  list.add(0, "f_0.vtp");
  list.add(2.5, "f&1.vtp");
  const std::vector<PvdEntry> entries = read_pvd(folder_ / "flow.pvd");
  ASSERT_EQ(entries.size(), 2u);
  EXPECT_EQ(entries[0].time, 0);
  EXPECT_EQ(entries[0].file, "f_0.vtp");
  EXPECT_EQ(entries[1].time, 2.5);
  EXPECT_EQ(entries[1].file, "f&1.vtp");
}

TEST_F(ReadVtp, AListStaysInItsFolder) {
  const auto problem = [this](const std::string& name, const std::string& time) {
    PvdWriter list(folder_ / "flow.pvd");
    list.add(1, "good.vtp");
    std::string text = folder_.read("flow.pvd");
    text.replace(text.find("good.vtp"), 8, name);
    text.replace(text.find("timestep=\"1\""), 12, "timestep=\"" + time + "\"");
    return fault_of([&] { parse_pvd(text, "flow.pvd"); }).problem;
  };
  for (const char* name : {"/etc/passwd", "../f.vtp", "a/../../f.vtp", ""}) {
    EXPECT_THAT(problem(name, "1"), HasSubstr("not in the folder")) << name;
  }
  EXPECT_THAT(problem("f.vtp", "inf"), HasSubstr("frame 1 has no valid time"));
  EXPECT_THAT(problem("f.vtp", "1s"), HasSubstr("frame 1 has no valid time"));
}

TEST_F(ReadVtp, EveryTruncatedListIsRefused) {
  PvdWriter list(folder_ / "flow.pvd");
  list.add(1, "f.vtp");
  const std::string text = folder_.read("flow.pvd");
  for (std::size_t size = 0; size + 1 < text.size(); ++size) {  // the last byte is a line end
    EXPECT_THAT(fault_of([&] { parse_pvd(text.substr(0, size), "x"); }).problem,
                HasSubstr("not a complete list"));
  }
}

}  // namespace
}  // namespace sabo
