#pragma once

#include <string>
#include <vector>

#include "bench/measurement.hpp"

namespace sabo {

/// Where and with what something was measured.
struct BenchMachine {
  std::string version;   ///< of the program
  std::string compiler;  ///< and the type of the build
  std::string cpu;
  std::string instruction_set;  ///< the widest of the machine, which runs use
  int threads = 0;
  int cores = 0;     ///< processors that the system offers
  double load = 0;   ///< programs that wanted to run during the last minute
  std::string date;  ///< UTC, ISO 8601
};

/// A table for the terminal: the first column is text, the others are numbers with their units in
/// the header.
struct BenchTable {
  std::string title;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> notes;  ///< lines below: what a number means, what it is to be judged by
};

/// What one part measured.
struct BenchResult {
  std::vector<BenchTable> tables;
  std::vector<Measurement> measurements;
};

/// What must be said before the numbers: nothing on an idle machine.
std::string warning_of(const BenchMachine& machine);

/// "1 thread", "2 threads".
std::string threads_text(int threads);

/// A table in columns, with its title above and its notes below.
std::string text_of(const BenchTable& table);

/// All results as JSON: the machine, and each measurement with value, unit, low, high, repeats.
std::string json_of(const BenchMachine& machine, const std::vector<Measurement>& measurements);

}  // namespace sabo
