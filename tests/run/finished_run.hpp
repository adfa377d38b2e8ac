#pragma once

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "io/case_file/read_case.hpp"
#include "io/gis/raster_file.hpp"
#include "run/simulation.hpp"

namespace sabo {

/// A case run from its files to a folder, and what was written there.
struct FinishedRun {
  RunResult result;
  std::filesystem::path folder;

  std::string text_of(const std::string& file) const {
    std::ostringstream text;
    text << std::ifstream(folder / file, std::ios::binary).rdbuf();
    return text.str();
  }

  /// The last row of a series, by the names of its columns.
  std::map<std::string, double> last_row(const std::string& file) const {
    std::istringstream lines(text_of(file));
    std::string header, row;
    std::getline(lines, header);
    for (std::string line; std::getline(lines, line);) row = line;
    std::map<std::string, double> values;
    std::istringstream names(header), numbers(row);
    for (std::string name, number;
         std::getline(names, name, ',') && std::getline(numbers, number, ',');)
      values[name] = std::stod(number);
    return values;
  }

  /// Sum of depth x cell area over a map of depths, m3.
  double volume_of(const std::string& map) const {
    const Raster depth = RasterFile(folder / map, "map").read();
    double sum = 0;
    for (const double value : depth.values)
      if (!std::isnan(value)) sum += value * depth.grid.cell_area();
    return sum;
  }
};

/// Runs the case of a folder with some keys changed. Fails the test when the case has faults.
inline FinishedRun run_to_end(const std::filesystem::path& case_folder,
                              const std::filesystem::path& run_folder,
                              const std::vector<Override>& overrides) {
  Faults faults;
  const Case c = read_case(case_folder, faults, overrides);
  for (const Fault& fault : faults.list()) ADD_FAILURE() << to_string(fault);
  if (!faults.empty()) return {};
  RunOptions options;
  options.folder = run_folder;
  return {run_case(c, options), run_folder};
}

}  // namespace sabo
