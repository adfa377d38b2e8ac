#include <algorithm>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <omp.h>

#include "app/commands.hpp"
#include "base/error.hpp"
#include "bench/parts.hpp"
#include "io/output/file.hpp"
#include "solver/make_backend.hpp"

namespace sabo {
namespace {

struct BenchOptions {
  BenchSettings settings;
  std::string json;
  std::vector<std::string> only;
  std::string method;
  std::string backend = "cpu";
  std::optional<double> largest;
};

std::vector<std::string_view> part_names(BackendKind backend) {
  std::vector<std::string_view> names;
  for (const BenchPart& part : bench_parts(backend)) names.push_back(part.name);
  return names;
}

/// The parts that are wanted, in the order of the list.
std::vector<BenchPart> chosen_parts(const std::vector<std::string>& only, BackendKind backend) {
  if (only.empty()) return bench_parts(backend);
  for (const std::string& name : only)
    if (std::ranges::count(part_names(backend), name) == 0)
      throw CaseError("--only", fmt::format("there is no part \"{}\"", name),
                      fmt::format("give some of {}", fmt::join(part_names(backend), ", ")));
  std::vector<BenchPart> parts;
  for (const BenchPart& part : bench_parts(backend))
    if (std::ranges::count(only, part.name) > 0) parts.push_back(part);
  return parts;
}

/// All methods, or the one that is named.
std::vector<Method> chosen_methods(const std::string& name) {
  std::vector<Method> methods;
  for (const Method method : {Method::fast, Method::paper})
    if (name.empty() || name == word_of(method)) methods.push_back(method);
  if (methods.empty())
    throw CaseError("--method", fmt::format("there is no method \"{}\"", name),
                    fmt::format("give {}", fmt::join(Words<Method>::list, " or ")));
  return methods;
}

/// The processor, or a graphics card that is there.
BackendKind chosen_backend(const std::string& name) {
  for (const BackendKind kind : {BackendKind::cpu, BackendKind::cuda}) {
    if (name != word_of(kind)) continue;
    if (const std::string fault = missing_backend(kind); !fault.empty())
      throw CaseError("--backend", fault, "measure --backend cpu");
    return kind;
  }
  throw CaseError("--backend", fmt::format("there is no backend \"{}\" to measure", name),
                  "give cpu or cuda");
}

int bench(const BenchOptions& options) {
  BenchSettings settings = options.settings;
  settings.backend = chosen_backend(options.backend);
  if (options.largest && settings.backend != BackendKind::cuda)
    throw CaseError("--largest", "is for flows on a card, which --backend cpu does not measure",
                    "leave it out or measure --backend cuda");
  settings.largest = options.largest.value_or(settings.largest);
  const std::vector<BenchPart> parts = chosen_parts(options.only, settings.backend);
  settings.methods = chosen_methods(options.method);
  const BenchMachine machine = bench_machine(settings);
  fmt::print("sabo {} ({})\n{}, {}, {}\n{}", machine.version, machine.compiler, machine.cpu,
             threads_text(machine.threads), machine.instruction_set, warning_of(machine));
  std::vector<Measurement> measurements;
  for (const BenchPart& part : parts) {
    const BenchResult result = part.measure(settings);
    for (const BenchTable& table : result.tables) fmt::print("\n{}", text_of(table));
    std::fflush(stdout);
    measurements.insert(measurements.end(), result.measurements.begin(), result.measurements.end());
  }
  if (!options.json.empty()) {
    write_file_atomically(options.json, json_of(machine, measurements));
    fmt::print("\nWrote {}\n", options.json);
  }
  return exit_done;
}

std::string part_list() {
  std::string text = "Parts:";
  for (const BackendKind backend : {BackendKind::cpu, BackendKind::cuda})
    for (const BenchPart& part : bench_parts(backend))
      text += fmt::format("\n  {:<12} {}{}", part.name, part.summary,
                          backend == BackendKind::cuda ? "; with --backend cuda" : "");
  return text;
}

}  // namespace

void add_bench_command(CLI::App& program, Action& action) {
  CLI::App* command =
      program.add_subcommand("bench", "Measure how fast this program is on this machine");
  const auto options = std::make_shared<BenchOptions>();
  options->settings.threads = omp_get_max_threads();
  command->add_flag("--quick", options->settings.quick,
                    "small scenes, few repetitions: to see that it works");
  command->add_option("--threads", options->settings.threads, "most threads; default: all")
      ->type_name("N")
      ->check(CLI::Range(1, 1024).description(""));
  command->add_option("--method", options->method, "method to measure; default: each")
      ->type_name(fmt::format("{}", fmt::join(Words<Method>::list, "|")));
  command->add_option("--backend", options->backend, "what to measure; default: cpu")
      ->type_name("cpu|cuda");
  command
      ->add_option("--largest", options->largest,
                   "most particles of the fluid on a card; default: all that fit, up to 1e8")
      ->type_name("N")
      ->check(CLI::Range(2e4, 1e8).description(""));
  command->add_option("--json", options->json, "write the results there, for compare_bench.py")
      ->type_name("FILE");
  command->add_option("--only", options->only, "parts to measure; default: all")
      ->delimiter(',')
      ->type_name("PART,PART,...");
  command->footer(part_list() +
                  "\n\nExamples:\n  sabo bench --json before.json\n"
                  "  sabo bench --only passes,steps --threads 1");
  command->callback([&action, options] { action = {"", [options] { return bench(*options); }}; });
}

}  // namespace sabo
