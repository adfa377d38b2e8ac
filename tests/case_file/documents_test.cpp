#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "support/folders.hpp"
#include <gtest/gtest.h>

#include "io/case_file/models.hpp"
#include "io/case_file/write_case.hpp"

namespace sabo {
namespace {

constexpr const char* head = R"(<!-- Written by `make docs` from the descriptions in src/. -->
# The case file

TOML; SI units, angles in degrees. A key that is not here is an error, with a suggestion. Relative
file names start at the folder of the case file. A file of lines or polygons in another coordinate
system is reprojected to that of the DEM; a raster in another one is refused.

`sabo new` writes a case to start from, `sabo check CASE` says what it holds and all that is wrong
with it, `sabo check CASE --defaults` prints it with every default. What the keys of the method do
to a result is in [method.md](method.md). Of the keys that name a release give one: `polygon`,
`thickness_raster` or `points`. A dam needs `crest`, `height` or a line with z.

)";

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

/// docs/case-file.md says what the program says; with SABO_UPDATE_DOCS it is made to.
TEST(Documents, CaseFileIsCurrent) {
  const std::filesystem::path file = repository() / "docs" / "case-file.md";
  std::string expected = head + keys_markdown();
  expected.pop_back();  // the empty line at its end
  if (std::getenv("SABO_UPDATE_DOCS")) std::ofstream(file, std::ios::binary) << expected;
  EXPECT_TRUE(text_of(file) == expected) << file << " is out of date: run `make docs`";
}

}  // namespace
}  // namespace sabo
