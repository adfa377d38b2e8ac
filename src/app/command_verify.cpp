#include <algorithm>
#include <cstdio>
#include <memory>

#include "verify/report.hpp"
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <omp.h>

#include "app/commands.hpp"
#include "app/stop_signals.hpp"
#include "app/terminal.hpp"
#include "base/error.hpp"

namespace sabo {
namespace {

struct VerifyOptions {
  std::vector<std::string> names;
  bool all = false, quick = false, extended = false, again = false;
  std::string method;
  std::string folder = "sabo-verify";
  int threads = 1;
};

/// Ends a case when the user wants to stop.
struct Stopped {};

std::vector<std::string_view> case_names() {
  std::vector<std::string_view> names;
  for (const Verification& verification : verifications()) names.push_back(verification.name);
  return names;
}

void list_cases() {
  for (const Verification& v : verifications()) {
    std::vector<std::string_view> methods;
    for (const Method method : v.methods) methods.push_back(word_of(method));
    fmt::print("{:<20} {} ({})\n", v.name, v.title, fmt::join(methods, ", "));
  }
  fmt::print("\nsabo verify NAME... runs some of them, sabo verify --all all.\n");
}

/// The cases that are wanted, in the order of the list, once for each method.
std::vector<std::pair<const Verification*, Method>> chosen(const VerifyOptions& options) {
  for (const std::string& name : options.names)
    if (std::ranges::count(case_names(), name) == 0)
      throw CaseError("NAME", fmt::format("there is no case \"{}\"", name),
                      fmt::format("give some of {}", fmt::join(case_names(), ", ")));
  const auto only = value_of_word<Method>(options.method);
  if (!options.method.empty() && !only)
    throw CaseError("--method", fmt::format("there is no method \"{}\"", options.method),
                    fmt::format("give {}", fmt::join(Words<Method>::list, " or ")));
  std::vector<std::pair<const Verification*, Method>> list;
  for (const Verification& v : verifications())
    if (options.all || std::ranges::count(options.names, v.name) > 0)
      for (const Method method : v.methods)
        if (!only || method == *only) list.emplace_back(&v, method);
  if (list.empty())
    throw CaseError("--method", "none of these cases is for that method",
                    "sabo verify lists the methods of each case");
  return list;
}

void clear_line() {
  if (is_terminal(stderr)) fmt::print(stderr, "\r\033[K");
}

VerifyRecord run(const Verification& v, const VerifySettings& settings,
                 const std::atomic<bool>& stop) {
  VerifySettings watched = settings;
  watched.on_progress = [&](double share) {
    if (stop) throw Stopped();
    if (is_terminal(stderr))
      fmt::print(stderr, "\r{} ({}) {:3.0f} %", v.name, word_of(settings.method), 100 * share);
  };
  watched.on_progress(0);
  VerifyRecord record = run_verification(v, watched);
  clear_line();
  return record;
}

int verify(const VerifyOptions& options) {
  if (options.names.empty() && !options.all) {
    list_cases();
    return exit_done;
  }
  const std::atomic<bool>& stop = catch_stop_signals();
  make_record_folder(options.folder);
  const Effort effort = options.quick      ? Effort::quick
                        : options.extended ? Effort::extended
                                           : Effort::full;
  std::ptrdiff_t run_count = 0, passed = 0;
  bool was_stopped = false;
  for (const auto& [verification, method] : chosen(options)) {
    VerifySettings settings;
    settings.method = method;
    settings.effort = effort;
    settings.threads = options.threads;
    settings.again = options.again;
    settings.folder = options.folder;
    std::optional<VerifyRecord> record;
    if (!options.again) record = read_record(options.folder, verification->name, method, effort);
    try {
      if (!record || !record->is_current) {
        record = run(*verification, settings, stop);
        write_record(*record, options.folder);
      }
    } catch (const Stopped&) {
      clear_line();
      was_stopped = true;
      break;
    }
    fmt::print("{}\n", text_of(*record));
    std::fflush(stdout);
    ++run_count;
    passed += record->holds() ? 1 : 0;
  }
  // The page also has what earlier calls left in the folder.
  const auto page = write_verify_page(read_records(options.folder, effort), options.folder);
  fmt::print("{} of {} cases pass. Open {}\n", passed, run_count, page.string());
  if (was_stopped) return exit_stopped;
  return passed == run_count ? exit_done : exit_run_failed;
}

}  // namespace

void add_verify_command(CLI::App& program, Action& action) {
  CLI::App* command = program.add_subcommand(
      "verify", "Run cases with a known outcome on this machine and compare; without names, list");
  const auto options = std::make_shared<VerifyOptions>();
  options->threads = omp_get_max_threads();
  command->add_option("NAME", options->names, "cases to run; default: list them")->type_name("");
  command->add_flag("--all", options->all, "run all cases");
  auto* quick =
      command->add_flag("--quick", options->quick, "coarse and short, to see that nothing broke");
  command->add_flag("--long", options->extended, "also resolutions that take hours")
      ->excludes(quick);
  command->add_flag("--again", options->again,
                    "run cases again of which the folder has a result of this very program");
  command->add_option("--method", options->method, "default: each that a case is for")
      ->type_name(fmt::format("{}", fmt::join(Words<Method>::list, "|")));
  command->add_option("--threads", options->threads, "number of threads; default: all")
      ->type_name("N")
      ->check(CLI::Range(1, 1024).description(""));
  command->add_option("-o,--output", options->folder, "folder of the results; default: sabo-verify")
      ->type_name("DIR");
  command->footer("Examples:\n  sabo verify\n  sabo verify slab --quick\n  sabo verify --all");
  command->callback([&action, options] { action = {"", [options] { return verify(*options); }}; });
}

}  // namespace sabo
