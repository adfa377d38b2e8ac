#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/convergence.hpp"
#include "io/output/index_page.hpp"
#include "run/batch_record.hpp"

namespace sabo {

/// One quantity over the spacings of a study.
struct StudyRow {
  struct Value {
    Scatter scatter;
    std::size_t runs = 0;  ///< that have the quantity
  };
  std::string label;                     ///< with its unit
  std::vector<std::optional<Value>> at;  ///< by spacing; none where no run has it
  GridConvergence convergence;           ///< of the means
  std::string remark;

  /// Below half an order the extrapolated value is a guess from afar.
  bool is_far() const { return convergence.order > 0 && convergence.order < least_shown_order; }
  /// No quantity that was never negative is so at the spacing of zero.
  bool falls_below_zero() const { return convergence.lowest >= 0 && convergence.extrapolated < 0; }
  bool shows_limit() const { return convergence.has_limit() && !is_far() && !falls_below_zero(); }
  static constexpr double least_shown_order = 0.5;
};

struct StudyTable {
  std::vector<double> spacings;  ///< from the coarsest, m
  bool has_members = false;
  std::vector<StudyRow> rows;
};

/// Quantities of all runs in the order in which they first come.
StudyTable study_table(const std::vector<BatchRecord>& records);

/// The table as text, a column for each spacing.
PageTable quantities_table(const StudyTable& table);

/// Times and sizes of the runs.
PageTable runs_table(const std::vector<BatchRecord>& records);

/// What to be aware of when the table is read, a sentence each.
std::vector<std::string> study_warnings(const std::vector<BatchRecord>& records,
                                        const StudyTable& table);

/// A number with so many digits, more before the point if need be, and without an exponent.
std::string number_text(double value, int digits = 4);

}  // namespace sabo
