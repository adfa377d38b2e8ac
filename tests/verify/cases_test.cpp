// Every case in its quick form, by every method it is for; gates are those of the case.

#include <set>

#include "support/temporary_folder.hpp"
#include "verify/verification.hpp"
#include <gtest/gtest.h>

namespace sabo {
namespace {

TEST(Verifications, HaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (const Verification& v : verifications()) {
    EXPECT_TRUE(names.insert(v.name).second) << v.name;
    EXPECT_FALSE(v.title.empty() || v.reference.empty() || v.methods.empty()) << v.name;
  }
}

class QuickCase : public testing::TestWithParam<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(All, QuickCase, testing::Range<std::size_t>(0, verifications().size()),
                         [](const auto& k) { return std::string(verifications()[k.param].name); });

TEST_P(QuickCase, MeetsItsGatesByTheDefaultMethod) {
  const Verification& verification = verifications()[GetParam()];
  double last = 0;
  const TemporaryFolder folder;
  VerifySettings settings;
  settings.folder = folder / "out";
  settings.effort = Effort::quick;
  settings.on_progress = [&](double share) {
    EXPECT_GE(share, last);
    last = share;
  };
  const Verdict verdict = verification.run(settings);
  EXPECT_NEAR(last, 1, 1e-9) << "progress ends at 1";
  EXPECT_FALSE(verdict.claims.empty());
  for (const Claim& claim : verdict.claims)
    EXPECT_TRUE(claim.holds()) << claim.what << ": " << claim.measured << " against "
                               << claim.expected;
}

}  // namespace
}  // namespace sabo
