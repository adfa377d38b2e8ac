#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "case/case.hpp"

namespace sabo {

/// What a study or a sweep needs of a finished run, from its manifest.
struct BatchRecord {
  double spacing = 0;    ///< m
  int member = 0;        ///< from 1; 0 when the starts are not jittered
  std::string folder;    ///< below that of the batch
  double simulated = 0;  ///< s
  double wall = 0;       ///< s
  double particles = 0;
  double median_layers = 0;
  bool at_rest = false;
  double energy_imbalance = 0;  ///< see EnergyBalance
  double energy_to_scheme = 0;  ///< share of what was released that the scheme itself took
  std::vector<std::pair<std::string, double>> quantities;  ///< "front run-out [m]" and so on

  /// A quantity by its label; none where the run has it not.
  std::optional<double> quantity(std::string_view label) const;
};

/// Labels of the quantities of all records in the order in which they first come.
std::vector<std::string> quantity_labels(const std::vector<BatchRecord>& records);

/// The record of the finished run in a folder; nothing when there is none, or when it is of another
/// case (the number of threads apart), of other inputs or by another version of the program.
std::optional<BatchRecord> finished_record(const std::filesystem::path& folder, const Case& c);

}  // namespace sabo
