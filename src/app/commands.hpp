#pragma once

#include <functional>
#include <string>

#include <CLI/App.hpp>

#include "app/exit_code.hpp"

namespace sabo {

/// What a command line asks for.
struct Action {
  std::string subject;             ///< of the faults it may find, e.g. the case; may be empty
  std::function<int()> carry_out;  ///< returns an ExitCode or throws
};

// Each adds one command to the program. Parsing a line that names it sets `action`.
void add_new_command(CLI::App& program, Action& action);
void add_check_command(CLI::App& program, Action& action);
void add_run_command(CLI::App& program, Action& action);
void add_study_command(CLI::App& program, Action& action);
void add_sweep_command(CLI::App& program, Action& action);
void add_plot_command(CLI::App& program, Action& action);
void add_report_command(CLI::App& program, Action& action);
void add_compare_command(CLI::App& program, Action& action);
void add_hazard_command(CLI::App& program, Action& action);
void add_export_command(CLI::App& program, Action& action);
void add_view_command(CLI::App& program, Action& action);
void add_info_command(CLI::App& program, Action& action);
void add_models_command(CLI::App& program, Action& action);
void add_bench_command(CLI::App& program, Action& action);
void add_verify_command(CLI::App& program, Action& action);

}  // namespace sabo
