#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace sabo {

/// Whether the path may be FG-GML: a folder, .xml or .zip that no raster driver of GDAL knows.
bool may_be_fg_gml(const std::filesystem::path& file);

/// Calls `use` with the name and the text of each tile of an .xml file, a folder or a .zip, in no
/// certain order. In a folder or .zip, tiles are the .xml files with DEM in their name, in folders
/// within and .zip files within (a .zip in a .zip at the deepest). One text is in memory at a time.
/// Throws CaseError at terrain.dem: nothing there, no tile in it, unreadable, text over 200 MB, too
/// many files.
void for_each_fg_gml(
    const std::filesystem::path& file,
    const std::function<void(const std::string& name, const std::string& text)>& use);

/// Tiles in ascending order of this count from the least to the most: first by survey, C before B
/// before A (DEM5C ... DEM5A), then by file name, which puts older dates before newer ones.
std::string fg_gml_rank(const std::string& name);

}  // namespace sabo
