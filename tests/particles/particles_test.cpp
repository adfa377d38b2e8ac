#include "particles/particles.hpp"

#include <gtest/gtest.h>

namespace sabo {
namespace {

Particles three() {
  Particles p;
  p.resize(3);
  for (std::uint32_t i = 0; i < 3; ++i) {
    p.position[i] = {1.0 * i, 2.0 * i, 3.0 * i};
    p.density[i] = 1000 + i;
    p.id[i] = 10 + i;
  }
  return p;
}

TEST(Particles, NewEntriesAreZero) {
  Particles p = three();
  p.resize(4);
  EXPECT_EQ(p.size(), 4u);
  EXPECT_EQ(p.position[3], Vec3d{});
  EXPECT_EQ(p.density[3], 0);
}

TEST(Particles, PermuteMovesWholeRowsAndMayLeaveSomeOut) {
  Particles p = three();
  p.permute({2, 0});
  ASSERT_EQ(p.size(), 2u);
  EXPECT_EQ(p.id[0], 12u);
  EXPECT_EQ(p.density[0], 1002);
  EXPECT_EQ(p.position[0], (Vec3d{2, 4, 6}));
  EXPECT_EQ(p.id[1], 10u);
}

TEST(Particles, AppendCopiesTheGivenRows) {
  Particles p = three();
  p.append(three(), {1});
  ASSERT_EQ(p.size(), 4u);
  EXPECT_EQ(p.id[3], 11u);
  EXPECT_EQ(p.position[3], (Vec3d{1, 2, 3}));
}

TEST(Particles, EveryFieldHasTheSameLength) {
  Particles p = three();
  p.append(three(), {0, 2});
  p.permute({4, 3, 2, 1});
  int fields = 0;
  p.for_each_shown_field(
      [&](const char* name, const char*, const char* meaning, const auto& values) {
        ++fields;
        EXPECT_EQ(values.size(), 4u) << name;
        EXPECT_STRNE(meaning, "");
      });
  EXPECT_EQ(fields, 8);
}

}  // namespace
}  // namespace sabo
