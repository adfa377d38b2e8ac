#include "run/avaframe.hpp"

#include <algorithm>
#include <cctype>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.hpp"
#include "io/case_file/toml_string.hpp"
#include "io/gis/crs.hpp"
#include "io/gis/raster_file.hpp"
#include "io/gis/read_vectors.hpp"
#include "run/load_case.hpp"

namespace sabo {
namespace {

namespace fs = std::filesystem;

/// Files of a folder with one of the extensions, sorted; none if there is no such folder.
std::vector<fs::path> files_in(const fs::path& folder, const std::vector<std::string>& extensions) {
  std::vector<fs::path> found;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    std::string extension = entry.path().extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (std::ranges::find(extensions, extension) != extensions.end()) found.push_back(entry.path());
  }
  std::ranges::sort(found);
  return found;
}

/// The text for a file of the project, relative to its folder.
std::string quoted(const fs::path& file, const fs::path& folder) {
  return toml_string(file.lexically_relative(folder).generic_string());
}

std::string terrain_text(const fs::path& folder, const fs::path& release) {
  const std::vector<fs::path> dems = files_in(folder, {".asc", ".tif", ".tiff"});
  if (dems.size() != 1) {
    throw CaseError(folder.string(),
                    fmt::format("has REL/ as an AvaFrame project, and {} rasters", dems.size()),
                    "leave the DEM as its only .asc or .tif file, or write a case.toml");
  }
  const bool has_crs = !is_unknown(RasterFile(dems.front(), "terrain.dem").crs());
  const std::string code = has_crs ? "" : code_of_vectors(release, "release.polygon");
  const std::string crs = has_crs        ? ""
                          : code.empty() ? "assume_metres = true\n"
                                         : fmt::format("crs = \"{}\"  # of the release\n", code);
  return fmt::format("[terrain]\ndem = {}\n{}\n", quoted(dems.front(), folder), crs);
}

std::string dam_text(const fs::path& folder) {
  const std::vector<fs::path> dams = files_in(folder / "DAM", {".shp"});
  if (dams.empty()) return "";
  return fmt::format(
      "[[structure]]\nname = \"dam\"\nline = {}  # its z is the crest\n"
      "thickness = 4  # m, assumed; the slope of its sides is not modelled\n\n",
      quoted(dams.front(), folder));
}

std::string path_text(const fs::path& folder) {
  const std::vector<fs::path> lines = files_in(folder / "LINES", {".shp"});
  const auto aimec = std::ranges::find_if(lines, [](const fs::path& file) {
    return file.stem().string().find("aimec") != std::string::npos;
  });
  if (aimec == lines.end()) return "";
  return fmt::format("[path]\nline = {}\n\n", quoted(*aimec, folder));
}

std::string left_out(const fs::path& folder, const std::vector<fs::path>& releases) {
  std::vector<std::string> parts;
  if (!files_in(folder / "ENT", {".shp"}).empty()) parts.emplace_back("entrainment (ENT)");
  if (!files_in(folder / "RES", {".shp"}).empty()) parts.emplace_back("resistance (RES)");
  for (std::size_t k = 1; k < releases.size(); ++k)
    parts.push_back("release " + releases[k].filename().string());
  return parts.empty() ? "" : fmt::format("; left out: {}", fmt::join(parts, ", "));
}

}  // namespace

std::optional<MadeCase> avaframe_case(const fs::path& given) {
  std::error_code error;
  if (!fs::is_directory(given, error) || fs::exists(given / "case.toml", error)) return {};
  const fs::path inputs = given / "Inputs";
  const fs::path folder = fs::is_directory(inputs / "REL", error) ? inputs : given;
  const std::vector<fs::path> releases = files_in(folder / "REL", {".shp"});
  if (releases.empty()) return {};

  const std::string name = name_of_case(given);
  std::string text = fmt::format(
      "# Made from the AvaFrame project {}.\ntitle = {}\n"
      "note = {}\n\n",
      name, toml_string(name),
      toml_string("Input of AvaFrame; material, spacing and dam thickness are assumed" +
                  left_out(folder, releases)));
  text += terrain_text(folder, releases.front());
  text +=
      fmt::format("[release]\npolygon = {}\nthickness_attribute = \"thickness\"\nnormal = true\n\n",
                  quoted(releases.front(), folder));
  text += "[material]  # assumed\npreset = \"yohutagawa_2010\"\npore_pressure_ratio = 0.5\n\n";
  text += dam_text(folder) + path_text(folder);
  text += "[numerics]\nspacing = 2\n\n[run]\nduration = 120\n";
  return MadeCase{std::move(text), folder};
}

}  // namespace sabo
