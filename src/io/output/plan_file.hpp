#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/output/map_line.hpp"

namespace sabo {

/// Writes lines as GeoJSON with the properties `kind` (a word of MapLine::Kind), `name`, `label`
/// (of one line of each name or of a group of them, "" of the others) and `filled`, in the
/// coordinates of `crs_wkt` ("" for none) to the millimetre; z where a line has it. Throws
/// RunError.
void write_plan(const std::filesystem::path& file, const std::vector<MapLine>& lines,
                const std::string& crs_wkt);

/// The lines of such a file, in its coordinates and order; what it holds besides is left out.
/// Throws CaseError when it cannot be read.
std::vector<MapLine> read_plan(const std::filesystem::path& file);

}  // namespace sabo
