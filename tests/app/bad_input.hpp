#pragma once

// Wrong cases, files and run folders, as users have them: each is refused with exit code 2, with
// the place and what to do about it, in bounded time and memory, and leaves nothing outside its
// folder.

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "support/temporary_folder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/program.hpp"

namespace sabo {

namespace fs = std::filesystem;

struct WrongInput {
  const char* what;
  const char* make;    ///< shell, in a folder with a good case
  const char* answer;  ///< regular expression that the answer holds
  const char* command = "sabo check . --no-forecast";
};

/// A level square of 40 m at 100 m with cells of 1 m, 2 m of material on a part of it, a dam
/// beside.
inline constexpr const char* good_case = R"(
{ echo ncols 40; echo nrows 40; echo xllcorner 0; echo yllcorner 0; echo cellsize 1
  echo NODATA_value -9999; for row in $(seq 40); do echo $(for k in $(seq 40); do echo 100; done); done
} >dem.asc
cat >case.toml <<'END'
[terrain]
dem = "dem.asc"
assume_metres = true
[release]
polygon = [[10, 10], [16, 10], [16, 16], [10, 16]]
thickness = 2
[material]
density = 1800
[[structure]]
name = "dam"
line = [[25, 5], [25, 30]]
height = 4
thickness = 3
[[section]]
name = "gate"
line = [[20, 5], [20, 30]]
[[zone]]
name = "field"
polygon = [[30, 5], [35, 5], [35, 30], [30, 30]]
[numerics]
spacing = 1
[run]
duration = 0.1
END
)";

// The address sanitizer maps terabytes that it never fills.
#if defined(__SANITIZE_ADDRESS__)
#define SABO_HAS_ASAN 1
#elif defined(__has_feature)
#define SABO_HAS_ASAN __has_feature(address_sanitizer)
#else
#define SABO_HAS_ASAN 0
#endif

/// Shell that bounds the memory of what runs after it to 3 GB.
inline constexpr const char* bounded_memory =
    SABO_HAS_ASAN ? "export ASAN_OPTIONS=hard_rss_limit_mb=3000" : "ulimit -v 3000000";

class BadInput : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    fs::create_directories(*folder_ / "good");
    const Outcome outcome = in("good", std::string(good_case) + "sabo check . --no-forecast");
    ASSERT_EQ(outcome.code, 0) << outcome.text;
  }
  static void TearDownTestSuite() { delete folder_; }

  static Outcome in(const std::string& name, const std::string& command) {
    return run_shell("cd '" + (*folder_ / name).string() + "' && { " + command + "\n}");
  }

  /// Each in a folder of its own.
  static void expect_refused(const std::vector<WrongInput>& inputs) {
    for (const WrongInput& input : inputs) {
      const fs::path place = *folder_ / "tried";
      fs::remove_all(place);
      fs::create_directories(place);
      fs::copy(*folder_ / "good", place / "case", fs::copy_options::recursive);
      // In a process of its own, so that the limits end with it.
      const Outcome outcome =
          in("tried/case", "{ " + std::string(input.make) + "\n} && " + bounded_memory +
                               " && export OMP_NUM_THREADS=1 && sabo() { "
                               "timeout -s KILL 20 \"" SABO_PROGRAM "\" \"$@\"; } && " +
                               input.command);
      EXPECT_EQ(outcome.code, 2) << input.what << ":\n" << outcome.text;
      EXPECT_THAT(outcome.text, testing::ContainsRegex(input.answer)) << input.what;
      for (const fs::directory_entry& entry : fs::directory_iterator(place))
        EXPECT_TRUE(entry.path().filename().string().starts_with("case")) << input.what << entry;
    }
    std::printf("%zu wrong inputs tried\n", inputs.size());
  }

  inline static TemporaryFolder* folder_ = nullptr;
};

}  // namespace sabo
