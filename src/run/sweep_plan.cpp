#include "run/sweep_plan.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.hpp"
#include "base/parsed_number.hpp"
#include "run/load_case.hpp"
#include "run/scene.hpp"

namespace sabo {
namespace {

constexpr std::size_t most_runs = 10'000;

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t at = text.find(separator);
    parts.push_back(text.substr(0, at));
    if (at == std::string_view::npos) return parts;
    text.remove_prefix(at + 1);
  }
}

[[noreturn]] void refuse(const std::string& problem) {
  throw CaseError("--vary", problem,
                  "write KEY=VALUE,VALUE,... or KEY=FIRST:LAST:STEP, e.g. "
                  "material.pore_pressure_ratio=0:0.6:0.2");
}

/// First, last and step; the last one counts when the steps meet it to rounding. Of whole numbers
/// all values are whole.
void add_range(std::string_view text, std::vector<Override::Value>& values) {
  std::vector<double> numbers;
  bool is_whole = true;
  for (const std::string_view part : split(text, ':')) {
    is_whole = is_whole && parsed_number<std::int64_t>(part);
    const auto number = parsed_number<double>(part);
    if (!number || !std::isfinite(*number)) refuse(fmt::format("\"{}\" is no number", part));
    numbers.push_back(*number);
  }
  if (numbers.size() != 3) refuse(fmt::format("\"{}\" is not FIRST:LAST:STEP", text));
  const double count = (numbers[1] - numbers[0]) / numbers[2];
  if (!(count >= 0 && count < most_runs))
    refuse(fmt::format("\"{}\" leads nowhere, or makes too many steps", text));
  for (int k = 0; k <= std::floor(count + 1e-9); ++k) {
    const double value = numbers[0] + k * numbers[2];
    if (is_whole)
      values.emplace_back(std::llround(value));
    else  // as one would write it: 0.3, not 0.30000000000000004
      values.emplace_back(*parsed_number<double>(fmt::format("{:.12g}", value)));
  }
}

/// Without what a name of a folder had better not hold.
std::string folder_text(const std::string& text) {
  std::string name;
  for (const char c : text) {
    const bool is_plain =
        std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '-' || c == '_' || c == '+';
    name += is_plain ? c : '_';
  }
  return name;
}

SweepRun run_of(const SweepRequest& request, const std::vector<std::size_t>& choice) {
  SweepRun run;
  std::vector<Override> overrides = request.overrides;
  std::vector<std::string> words;
  for (std::size_t k = 0; k < request.variations.size(); ++k) {
    const Variation& variation = request.variations[k];
    Override replacement = variation.key;
    replacement.value = variation.values[choice[k]];
    run.values.push_back(value_text(replacement.value));
    words.push_back(folder_text(variation.key.key + "-" + run.values.back()));
    overrides.push_back(std::move(replacement));
  }
  run.folder = fmt::format("{}", fmt::join(words, "_"));
  Faults faults;
  run.c = load_case(request.case_path, faults, overrides);
  faults.throw_if_any();
  make_scene(run.c, faults);
  Faults told;
  for (const Fault& fault : faults.list())
    told.add(fault.place, fmt::format("in run {}: {}", run.folder, fault.problem), fault.remedy);
  told.throw_if_any();
  return run;
}

}  // namespace

std::string value_text(const Override::Value& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::to_string(*whole);
  if (const auto* number = std::get_if<double>(&value)) return fmt::format("{}", *number);
  if (const auto* is_on = std::get_if<bool>(&value)) return *is_on ? "true" : "false";
  return std::get<std::string>(value);
}

Variation read_variation(const std::string& text) {
  const std::size_t equals = text.find('=');
  const std::size_t dot = text.rfind('.', equals);
  if (equals == std::string::npos || dot == std::string::npos || dot == 0 || dot + 1 == equals)
    refuse(fmt::format("\"{}\" names no key of a table", text));
  Variation variation{{text.substr(0, dot), text.substr(dot + 1, equals - dot - 1), {}}, {}};
  for (const std::string_view part : split(std::string_view(text).substr(equals + 1), ',')) {
    if (part.empty()) refuse(fmt::format("\"{}\" has an empty value", text));
    if (part.find(':') != std::string_view::npos) {
      add_range(part, variation.values);
    } else {
      variation.values.push_back(override_value(std::string(part)));
    }
  }
  return variation;
}

std::vector<SweepRun> sweep_plan(const SweepRequest& request) {
  if (request.variations.empty()) refuse("is missing");
  std::size_t count = 1;
  for (std::size_t k = 0; k < request.variations.size(); ++k) {
    const Variation& variation = request.variations[k];
    count *= variation.values.size();
    for (std::size_t other = 0; other < k; ++other)
      if (request.variations[other].name() == variation.name())
        refuse(variation.name() + " is given twice");
    if (count > most_runs) refuse(fmt::format("makes more than {} runs", most_runs));
  }
  for (const double depth : request.depths)
    if (!(std::isfinite(depth) && depth > 0))
      throw CaseError("--depths", fmt::format("{:g} m is no depth", depth), "give lengths above 0");

  std::vector<SweepRun> runs;
  std::set<std::string> folders;
  std::vector<std::size_t> choice(request.variations.size(), 0);
  for (std::size_t number = 0; number < count; ++number) {
    std::size_t rest = number;
    for (std::size_t k = choice.size(); k-- > 0;) {
      choice[k] = rest % request.variations[k].values.size();
      rest /= request.variations[k].values.size();
    }
    runs.push_back(run_of(request, choice));
    if (!folders.insert(runs.back().folder).second)
      refuse(fmt::format("{} is made twice", runs.back().folder));
  }
  return runs;
}

}  // namespace sabo
