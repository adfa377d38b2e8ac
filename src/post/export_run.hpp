#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sabo {

struct ExportOptions {
  std::filesystem::path run;
  std::filesystem::path output;                ///< "" for the folder `export` within the run
  std::vector<std::string> formats;            ///< of export_formats(); empty for all
  std::vector<double> depths{0.1, 0.5, 1, 2};  ///< of the outlines, m
};

/// ascii, gpkg, qgis.
std::vector<std::string> export_formats();

/// Writes for other software: every map as an ESRI ASCII grid, a GeoPackage with outlines of the
/// area that was deeper than some depths and with what stands on the map, and the maps themselves
/// with a style for QGIS each. Returns lines that say what was written. Throws CaseError.
std::vector<std::string> export_run(const ExportOptions& options);

}  // namespace sabo
