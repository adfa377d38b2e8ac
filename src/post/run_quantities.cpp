#include "post/run_quantities.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

namespace sabo {
namespace {

using Quantities = std::vector<std::pair<std::string, double>>;

struct Word {
  std::string_view text;
  std::string_view unit;
};

const std::map<std::string_view, Word>& zone_words() {
  static const std::map<std::string_view, Word> words{{"mean_wet", {"mean depth where wet", "m"}},
                                                      {"mean_all", {"mean depth", "m"}},
                                                      {"greatest", {"greatest depth", "m"}},
                                                      {"wet_area", {"wet area", "m2"}},
                                                      {"volume", {"volume", "m3"}}};
  return words;
}

const std::map<std::string_view, Word>& load_words() {
  static const std::map<std::string_view, Word> words{
      {"peak_force", {"peak force", "N"}},
      {"peak_time", {"time of the peak force", "s"}},
      {"filter", {"filter of the force", "s"}},
      {"hydrostatic", {"hydrostatic force by formula", "N"}},
      {"dynamic", {"dynamic force by formula", "N"}},
      {"row_time", {"time of the greatest mean force", "s"}}};
  return words;
}

/// Numbers of a table whose first text names their owner; a key without a word stands for itself.
void add_owned(const TomlTable& table, const char* owner_key,
               const std::map<std::string_view, Word>& words, Quantities& list) {
  const std::string owner = text_at(table, owner_key).value_or("");
  for (const TomlEntry& entry : table) {
    const auto value = number_at(table, entry.key);
    if (!value || !std::isfinite(*value)) continue;
    const auto word = words.find(entry.key);
    std::string name = entry.key;
    std::ranges::replace(name, '_', ' ');
    list.emplace_back(word == words.end()
                          ? fmt::format("{} {}", owner, name)
                          : fmt::format("{} {} [{}]", owner, word->second.text, word->second.unit),
                      *value);
  }
}

}  // namespace

Quantities quantities_of(const FinishedRun& run) {
  Quantities list;
  const auto volumes = run.tables("volumes");
  if (!volumes.empty())
    if (const auto released = number_at(*volumes.front(), "released"))
      list.emplace_back("released [m3]", *released);
  for (const TomlEntry& entry : run.table("quantities"))
    if (const auto value = number_at(run.table("quantities"), entry.key))
      list.emplace_back(entry.key, *value);
  for (const TomlTable* zone : run.tables("zones")) add_owned(*zone, "zone", zone_words(), list);
  for (const TomlTable* load : run.tables("load")) add_owned(*load, "name", load_words(), list);
  return list;
}

std::vector<QuantityPair> paired_quantities(const FinishedRun& a, const FinishedRun& b) {
  std::vector<QuantityPair> pairs;
  for (const auto& [label, value] : quantities_of(a)) pairs.push_back({label, value, std::nan("")});
  for (const auto& [label, value] : quantities_of(b)) {
    const auto found = std::ranges::find(pairs, label, &QuantityPair::label);
    if (found == pairs.end()) {
      pairs.push_back({label, std::nan(""), value});
    } else {
      found->b = value;
    }
  }
  return pairs;
}

}  // namespace sabo
