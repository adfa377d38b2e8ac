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
to a result is in [method.md](method.md). The ground is `terrain.dem` or `terrain.plane`. Of the ways to
give a release choose one: `polygon`, `thickness_raster`, `points`, `box`, or `dem_before` with `dem_after`.
Discharges that come in through lines, `[[inflow]]`, stand beside a release or in its place: each has a
`hydrograph` or `[[inflow.surge]]`, and depth and speed at its line follow from a `froude` number unless a
`speed` is given ([theory](theory.md)). A check dam or deflection wall needs a `thickness` and one of `crest`, `height` and a line with z.

A structure is of one `kind`, whose keys say so. A slit with a sill is one more notch, one with a
height a culvert. Openings should be four particles wide: `sabo check` says which spacing does it for
the ones that are narrower. Below two particles a slit or the gap of a grid is refused, for nothing would
pass; a notch is not, since a dam is overtopped beside it.
Outlines of buildings may touch, and holes in them are courtyards; they must not overlap by more than
1 % of the smaller one. In the outputs structures and bodies go by their names, all different.

A body is of one `kind`, whose keys say so. What flows meets its surface: particles fill it to the depth
of the kernel, so boxes and plates should be some spacings thick. A mesh must be closed; parts of it may
overlap, and a part within another is a cavity. Where bodies, dams and ground overlap the ground comes
first, then the dams, then the bodies in their order.

)";

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

/// Fails when a document does not hold the expected text; with SABO_UPDATE_DOCS it is made to.
void expect_current(const std::string& name, const std::string& expected) {
  const std::filesystem::path file = repository() / "docs" / name;
  if (std::getenv("SABO_UPDATE_DOCS")) std::ofstream(file, std::ios::binary) << expected;
  EXPECT_TRUE(text_of(file) == expected) << file << " is out of date: run `make docs`";
}

/// The document with what stands between "<!-- mark -->" and the next "<!-- end -->" replaced.
std::string filled(std::string text, const std::string& mark, const std::string& content) {
  const std::string begin = "<!-- " + mark + " -->\n";
  const std::size_t from = text.find(begin);
  const std::size_t to = text.find("<!-- end -->", from);
  EXPECT_NE(to, std::string::npos) << "no place for " << mark;
  if (to == std::string::npos) return text;
  return text.replace(from + begin.size(), to - from - begin.size(), content);
}

TEST(Documents, CaseFileIsCurrent) {
  std::string expected = head + keys_markdown();
  expected.pop_back();  // the empty line at its end
  expect_current("case-file.md", expected);
}

TEST(Documents, PagesOfTheLawsAreCurrent) {
  for (const Rheology& law : all_rheologies()) {
    const std::string name = "rheology/" + std::string(name_of(law)) + ".md";
    const std::string text = text_of(repository() / "docs" / name);
    expect_current(name, filled(text, "keys", keys_table(list_keys(law))));
  }
  const std::string text = text_of(repository() / "docs" / "rheology" / "README.md");
  expect_current("rheology/README.md",
                 filled(filled(text, "laws", laws_table("")), "presets", presets_markdown()));
}

}  // namespace
}  // namespace sabo
