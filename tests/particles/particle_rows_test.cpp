#include "particles/particle_rows.hpp"

#include <numeric>

#include <gtest/gtest.h>

namespace sabo {
namespace {

using Ids = std::vector<std::uint32_t>;

/// With the numbers 10 to 14.
Particles five() {
  Particles p;
  p.resize(5);
  std::iota(p.id.begin(), p.id.end(), 10u);
  for (std::size_t i = 0; i < 5; ++i) p.position[i] = {1.0 * static_cast<double>(i), 0, 0};
  return p;
}

TEST(ParticleRows, AreChangedWhereTheyAreAndWhatIsAddedComesLast) {
  Particles all = five();
  change_rows(all, {1, 3}, [](Particles& some) {
    EXPECT_EQ(some.id, (Ids{11, 13}));
    some.density = {7, 8};
    some.resize(3);
    some.id[2] = 99;
  });
  EXPECT_EQ(all.id, (Ids{10, 11, 12, 13, 14, 99}));
  EXPECT_EQ(all.density, (std::vector<double>{0, 7, 0, 8, 0, 0}));
  EXPECT_EQ(all.position[3], (Vec3d{3, 0, 0}));
}

TEST(ParticleRows, AreTakenOutAndTheOthersKeepTheirOrder) {
  Particles all = five();
  const Particles taken = take_out(all, {0, 3});
  EXPECT_EQ(taken.id, (Ids{10, 13}));
  EXPECT_EQ(taken.position[1], (Vec3d{3, 0, 0}));
  EXPECT_EQ(all.id, (Ids{11, 12, 14}));
  EXPECT_EQ(all.position[2], (Vec3d{4, 0, 0}));
  EXPECT_EQ(take_out(all, {}).size(), 0u);
  EXPECT_EQ(take_out(all, {0, 1, 2}).id, (Ids{11, 12, 14}));
  EXPECT_EQ(all.size(), 0u);
}

TEST(ParticleRows, OfTheTailBecomeASetOfTheirOwn) {
  Particles all = five();
  EXPECT_EQ(take_tail(all, 3).id, (Ids{13, 14}));
  EXPECT_EQ(all.id, (Ids{10, 11, 12}));
  EXPECT_EQ(take_tail(all, 3).size(), 0u);
}

}  // namespace
}  // namespace sabo
