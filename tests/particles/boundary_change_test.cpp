#include "particles/boundary_change.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace sabo {
namespace {

Particles numbered(const std::vector<std::uint32_t>& ids) {
  Particles p;
  p.resize(ids.size());
  for (std::size_t k = 0; k < ids.size(); ++k) {
    p.id[k] = ids[k];
    p.density[k] = 1000 + ids[k];
  }
  return p;
}

TEST(IdRuns, HoldTheirNumbersAndNoOthers) {
  EXPECT_TRUE(rc::check("as one number after the other is compared", [] {
    std::vector<IdRun> runs;
    std::uint32_t next = 0;
    for (int k = *rc::gen::inRange(0, 6); k > 0; --k) {
      const auto first = next + static_cast<std::uint32_t>(*rc::gen::inRange(0, 4));
      const auto count = static_cast<std::uint32_t>(*rc::gen::inRange(1, 5));
      runs.push_back({first, count});
      next = first + count;
    }
    for (std::uint32_t id = 0; id < next + 3; ++id) {
      bool is_in = false;
      for (const IdRun& run : runs)
        for (std::uint32_t k = 0; k < run.count; ++k) is_in = is_in || run.first + k == id;
      RC_ASSERT((IdRuns{runs.data(), runs.size()}.hold(id)) == is_in);
    }
  }));
}

TEST(BoundaryChange, LeavesTheOthersInTheirOrderAndAppends) {
  Particles boundary = numbered({7, 3, 21, 4, 20, 5, 9});
  const BoundaryChange change{{{3, 2}, {20, 1}}, numbered({30, 31})};
  change.apply_to(boundary);
  EXPECT_EQ(boundary.id, (std::vector<std::uint32_t>{7, 21, 5, 9, 30, 31}));
  EXPECT_EQ(boundary.density, (std::vector<double>{1007, 1021, 1005, 1009, 1030, 1031}));
}

TEST(BoundaryChange, IsEmptyWithoutAnythingToDo) {
  EXPECT_TRUE(BoundaryChange{}.is_empty());
  EXPECT_FALSE((BoundaryChange{{{3, 1}}, {}}.is_empty()));
  EXPECT_FALSE((BoundaryChange{{}, numbered({1})}.is_empty()));
}

}  // namespace
}  // namespace sabo
