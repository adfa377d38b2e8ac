#pragma once

namespace sabo {

/// What the program ends with.
enum ExitCode : int {
  exit_done = 0,
  exit_case_is_wrong = 2,  ///< or the command line
  exit_run_failed = 3,
  exit_stopped = 130
};

}  // namespace sabo
