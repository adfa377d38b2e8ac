#pragma once

#include "app/progress_line.hpp"

namespace sabo {

/// Shows how a run stands on stdout: one line that is redrawn on a terminal, else a new line now
/// and then.
class ProgressDisplay {
 public:
  explicit ProgressDisplay(bool has_dam);

  /// May be called as often as one likes.
  void show(const RunProgress& progress);

  /// Ends the line that was redrawn; call it before anything else is printed.
  void finish();

 private:
  bool has_dam_;
  bool redraws_;
  bool is_line_open_ = false;
  double next_ = 0;  // wall clock of the run, s
  Pace pace_;
};

}  // namespace sabo
