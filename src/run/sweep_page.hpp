#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "io/output/index_page.hpp"
#include "run/batch_record.hpp"

namespace sabo {

struct SweepRow {
  std::vector<std::string> values;  ///< one per key
  BatchRecord record;
};

struct SweepTable {
  std::vector<std::string> keys;
  std::vector<SweepRow> rows;
};

/// A row a run: its values and its quantities.
PageTable sweep_table(const SweepTable& table);

struct SweepPage {
  const Case& c;
  const SweepTable& table;
  std::vector<PagePicture> pictures;
  std::string warning;
};

/// Writes runs.csv, charts and index.html; returns the page.
std::filesystem::path write_sweep(const SweepPage& sweep, const std::filesystem::path& folder);

}  // namespace sabo
