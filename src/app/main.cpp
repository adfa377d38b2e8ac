#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <new>
#include <string>
#include <system_error>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

#include "app/commands.hpp"
#include "app/messages.hpp"
#include "app/suggestions.hpp"
#include "base/version.hpp"

namespace sabo {
namespace {

constexpr const char* examples = R"(Examples:
  sabo new yohutagawa demo                   write an example with its input files
  sabo check demo                            what the case holds, and what is wrong with it
  sabo run demo --spacing 1.5 --duration 60  run it, coarser and shorter than it says
  sabo study demo --spacings 4,3,2.2         run it at each spacing: what depends on it
  sabo plot demo-run --times 10,30,60        draw the flow at these times
  sabo report demo-run                       one page to print and to hand on
  sabo view demo-run                         the flow in 3D, in a browser
  sabo info demo-run                         what came out
  sabo compare without-dam with-dam          what a dam changes
  sabo hazard demo-run --rules japan         classes by rules that you can change

Exit codes: 0 done, 2 the case or the command line is wrong, 3 the run failed, 130 interrupted.)";

void describe_program(CLI::App& program, Action& action) {
  program.name("sabo");
  program.set_version_flag("--version", fmt::format("sabo {}", build_version));
  program.require_subcommand(1);
  program.footer(examples);
  add_new_command(program, action);
  add_check_command(program, action);
  add_run_command(program, action);
  add_study_command(program, action);
  add_sweep_command(program, action);
  add_plot_command(program, action);
  add_report_command(program, action);
  add_compare_command(program, action);
  add_hazard_command(program, action);
  add_export_command(program, action);
  add_view_command(program, action);
  add_info_command(program, action);
  add_models_command(program, action);
  add_bench_command(program, action);
  add_verify_command(program, action);
}

/// Throws what the command throws.
int run_program(int argc, char** argv, Action& action) {
  CLI::App program("Debris flows in three dimensions, from a DEM to a deposit map");
  describe_program(program, action);
  if (argc < 2) {
    fmt::print("{}", program.help());
    return exit_case_is_wrong;
  }
  if (const std::string fault = fault_of_command(program, argv[1]); !fault.empty()) {
    print_error(fault);
    return exit_case_is_wrong;
  }
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& help_or_version) {
    return program.exit(help_or_version);
  } catch (const CLI::ParseError& error) {
    print_error(explained(program, error));
    return exit_case_is_wrong;
  }
  const int code = action.carry_out();
  if (std::fflush(stdout) != 0) throw RunError("cannot write to the standard output");
  return code;
}

constexpr const char* no_memory =
    "not enough memory; try a larger numerics.spacing or a smaller terrain.crop";

/// No exception leaves a loop on several threads: it ends the program here.
[[noreturn]] void end_in_threads() {
  try {
    if (const std::exception_ptr thrown = std::current_exception()) std::rethrow_exception(thrown);
  } catch (const std::bad_alloc&) {
    print_error(no_memory);
    std::_Exit(exit_run_failed);
  } catch (...) {
  }
  std::abort();
}

}  // namespace
}  // namespace sabo

// NOLINTNEXTLINE(bugprone-exception-escape): only if an error cannot even be printed
int main(int argc, char** argv) {
  std::set_terminate(sabo::end_in_threads);
  sabo::Action action;
  try {
    return sabo::run_program(argc, argv, action);
  } catch (const sabo::CaseError& error) {
    sabo::print_faults(action.subject, error.faults());
    return sabo::exit_case_is_wrong;
  } catch (const std::bad_alloc&) {
    sabo::print_error(sabo::no_memory);
  } catch (const std::filesystem::filesystem_error& error) {
    sabo::print_error(error.what());
  } catch (const std::system_error&) {  // of fmt::print
    sabo::print_error("cannot write to the standard output");
  } catch (const std::exception& error) {  // RunError among them
    sabo::print_error(error.what());
  }
  return sabo::exit_run_failed;
}
