#include <filesystem>

#include "support/folders.hpp"
#include "support/temporary_folder.hpp"
#include <gtest/gtest.h>

#include "run/finished_run.hpp"

// examples/dangchuan7 on the real surface, coarse and short.

namespace sabo {
namespace {

namespace fs = std::filesystem;

TEST(Dangchuan, RunsOnTheRealSurface) {
  const fs::path data = data_folder() / "terrain" / "dangchuan7_1m";
  if (!fs::exists(data)) GTEST_SKIP() << "no data: set SABO_DATA";
  const TemporaryFolder folder;
  fs::create_directory(folder / "case");
  fs::copy(repository() / "examples" / "dangchuan7" / "case.toml", folder / "case");
  for (const char* file : {"dc7_dem_1411slide.txt", "pos_list.txt"})
    fs::create_symlink(data / file, folder / "case" / file);

  const FinishedRun run = run_to_end(folder / "case", folder / "run",
                                     {{"numerics", "spacing", 3.0}, {"run", "duration", 2.0}});
  ASSERT_EQ(run.result.end, RunEnd::finished) << run.result.reason;
  constexpr double volume = 24365;  // m3, one for each point
  const auto volumes = run.last_row("series/volumes.csv");
  EXPECT_NEAR(volumes.at("released [m3]"), volume, 1e-6 * volume);
  EXPECT_EQ(volumes.at("outflow [m3]"), 0);
  EXPECT_NEAR(run.volume_of("maps/dep.tif"), volume, 1e-3 * volume);
}

}  // namespace
}  // namespace sabo
