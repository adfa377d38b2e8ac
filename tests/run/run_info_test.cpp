#include "run/run_info.hpp"

#include "support/fault_of.hpp"
#include "support/temporary_folder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sabo {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(RunInfo, PrintsTheManifestWithUnits) {
  const TemporaryFolder folder;
  folder.write("manifest.toml",
               "run_folder_version = 1\n[run]\nend = \"failed\"\nreason = \"\"\nwall_s = 12.5\n"
               "boundary_particles = 42\n[[volumes]]\ndam = \"upper\"\nbeyond = 3510.0\n"
               "[[volumes]]\ndam = \"lower\"\n[inputs]\n\"/a_b/dem.tif\" = \"89f98e33\"\n");
  std::filesystem::create_directory(folder / "maps");
  folder.write("maps/dep.tif", std::string(1500, 'x'));
  folder.write("maps/pfd.tif", std::string(500, 'x'));
  const std::string text = run_info_text(folder / "");
  EXPECT_THAT(text, HasSubstr("\nrun\n  end                  failed\n"));
  EXPECT_THAT(text, HasSubstr("  wall                 12.5 s\n  boundary particles   42\n"));
  EXPECT_THAT(text, Not(HasSubstr("reason")));
  EXPECT_THAT(text, HasSubstr("  dam                  upper\n  beyond               3510 m3\n"));
  EXPECT_THAT(text, HasSubstr("  dam                  lower\n"));
  EXPECT_THAT(text, HasSubstr("  /a_b/dem.tif         89f98e33\n"));
  EXPECT_THAT(text, HasSubstr("  maps/                   2.0 kB in 2 files\n"));
}

TEST(RunInfo, RefusesWhatIsNoRun) {
  const TemporaryFolder folder;
  const auto info = [&] { run_info_text(folder / ""); };
  EXPECT_THAT(fault_of(info).problem, HasSubstr("no readable manifest.toml"));
  folder.write("manifest.toml", "[project]\nname = \"something else\"\n");
  EXPECT_THAT(fault_of(info).problem, HasSubstr("has no table [run]"));
  folder.write("manifest.toml", "[run\n");
  EXPECT_THAT(fault_of(info).place, HasSubstr("manifest.toml:1"));
  EXPECT_THROW(run_info_text(folder / "nothing"), CaseError);
}

}  // namespace
}  // namespace sabo
