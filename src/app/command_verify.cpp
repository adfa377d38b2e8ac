#include <algorithm>
#include <atomic>
#include <cstdio>
#include <map>
#include <memory>
#include <mutex>
#include <thread>

#include "verify/report.hpp"
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <omp.h>

#include "app/commands.hpp"
#include "app/stop_signals.hpp"
#include "app/terminal.hpp"
#include "base/error.hpp"
#include "base/host_loops.hpp"
#include "io/output/file.hpp"

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

/// A case by one of its methods.
struct Chosen {
  const Verification* verification;
  Method method;

  std::string name() const { return fmt::format("{} ({})", verification->name, word_of(method)); }
};

/// The cases that are wanted, in the order of the list, once for each method.
std::vector<Chosen> chosen(const VerifyOptions& options) {
  for (const std::string& name : options.names)
    if (std::ranges::count(case_names(), name) == 0)
      throw CaseError("NAME", fmt::format("there is no case \"{}\"", name),
                      fmt::format("give some of {}", fmt::join(case_names(), ", ")));
  const auto only = value_of_word<Method>(options.method);
  if (!options.method.empty() && !only)
    throw CaseError("--method", fmt::format("there is no method \"{}\"", options.method),
                    fmt::format("give {}", fmt::join(Words<Method>::list, " or ")));
  std::vector<Chosen> list;
  for (const Verification& v : verifications())
    if (options.all || std::ranges::count(options.names, v.name) > 0)
      for (const Method method : v.methods)
        if (!only || method == *only) list.push_back({&v, method});
  if (list.empty())
    throw CaseError("--method", "none of these cases is for that method",
                    "sabo verify lists the methods of each case");
  return list;
}

/// Runs cases side by side, each with its share of the threads: most are too small for many.
class CaseRuns {
 public:
  CaseRuns(const VerifyOptions& options, Effort effort, const std::atomic<bool>& stop)
      : options_(options), effort_(effort), stop_(stop), cases_(chosen(options)) {}

  void carry_out() {
    const int count = std::min(options_.threads, static_cast<int>(cases_.size()));
    threads_ = std::max(1, options_.threads / count);
    ThrownInside thrown;
    std::vector<std::jthread> workers;
    for (int k = 0; k < count; ++k) workers.emplace_back([&] { thrown.watch([&] { work(); }); });
    workers.clear();  // waits for them
    thrown.rethrow();
  }

  std::size_t passed() const { return passed_; }
  std::size_t finished() const { return finished_; }
  bool was_stopped() const { return was_stopped_; }

 private:
  void work() {
    try {
      for (std::size_t k = next_++; k < cases_.size() && !stop_; k = next_++) carry_out(k);
    } catch (const Stopped&) {
      was_stopped_ = true;
    } catch (...) {
      next_ = cases_.size();  // the others end with what they are at
      throw;
    }
    if (stop_) was_stopped_ = true;
  }

  void carry_out(std::size_t k) {
    const auto& [verification, method] = cases_[k];
    VerifySettings settings;
    settings.method = method;
    settings.effort = effort_;
    settings.threads = threads_;
    settings.again = options_.again;
    settings.folder = options_.folder;
    settings.on_progress = [this, k](double share) {
      if (stop_) throw Stopped();
      tell(k, share);
    };
    std::optional<VerifyRecord> record;
    if (!options_.again) record = read_record(options_.folder, verification->name, method, effort_);
    if (!record || !record->is_current) {
      settings.on_progress(0);
      record = run_verification(*verification, settings);
      write_record(*record, options_.folder);
    }
    const std::lock_guard lock(output_);
    running_.erase(k);
    clear_line();
    fmt::print("{}\n", text_of(*record));
    std::fflush(stdout);
    ++finished_;
    passed_ += record->holds() ? 1 : 0;
  }

  /// One line with all that runs.
  void tell(std::size_t k, double share) {
    const std::lock_guard lock(output_);
    running_[k] = share;
    if (!is_terminal(stderr)) return;
    std::vector<std::string> parts;
    for (const auto& [of, part] : running_)
      parts.push_back(fmt::format("{} {:3.0f} %", cases_[of].name(), 100 * part));
    clear_line();
    fmt::print(stderr, "{}", fmt::join(parts, ", "));
  }

  static void clear_line() {
    if (is_terminal(stderr)) fmt::print(stderr, "\r\033[K");
  }

  const VerifyOptions& options_;
  Effort effort_;
  const std::atomic<bool>& stop_;
  std::vector<Chosen> cases_;
  int threads_ = 1;  // of a case
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> was_stopped_ = false;
  std::mutex output_;
  std::map<std::size_t, double> running_;  // share that is done
  std::size_t finished_ = 0, passed_ = 0;
};

int verify(const VerifyOptions& options) {
  if (options.names.empty() && !options.all) {
    list_cases();
    return exit_done;
  }
  const std::atomic<bool>& stop = catch_stop_signals();
  make_folder(options.folder);
  const Effort effort = options.quick      ? Effort::quick
                        : options.extended ? Effort::extended
                                           : Effort::full;
  CaseRuns runs(options, effort, stop);
  runs.carry_out();
  // The page also has what earlier calls left in the folder.
  const auto page = write_verify_page(read_records(options.folder, effort), options.folder);
  fmt::print("{} of {} cases pass. Open {}\n", runs.passed(), runs.finished(), page.string());
  if (runs.was_stopped()) return exit_stopped;
  return runs.passed() == runs.finished() ? exit_done : exit_run_failed;
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
  command
      ->add_option("--threads", options->threads,
                   "number of threads, shared out among the cases, which run side by side; "
                   "default: all")
      ->type_name("N")
      ->check(CLI::Range(1, 1024).description(""));
  command->add_option("-o,--output", options->folder, "folder of the results; default: sabo-verify")
      ->type_name("DIR");
  command->footer("Examples:\n  sabo verify\n  sabo verify slab --quick\n  sabo verify --all");
  command->callback([&action, options] { action = {"", [options] { return verify(*options); }}; });
}

}  // namespace sabo
