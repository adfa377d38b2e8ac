#include <algorithm>
#include <array>
#include <string_view>

#include "report/report_maps.hpp"
#include <fmt/format.h>

#include "analysis/columns.hpp"

namespace sabo {
namespace {

enum class Threshold { film, little, none };

struct KnownMap {
  std::string_view name;
  Threshold threshold;  ///< what is left out
  bool is_expected;     ///< every run has it
};

// In the order of the report.
constexpr std::array known_maps{
    KnownMap{"pfd", Threshold::film, true},   KnownMap{"pfv", Threshold::little, true},
    KnownMap{"ppr", Threshold::little, true}, KnownMap{"pmf", Threshold::little, false},
    KnownMap{"pft", Threshold::film, false},  KnownMap{"tarr", Threshold::none, true},
    KnownMap{"dep", Threshold::film, true},   KnownMap{"det", Threshold::film, false}};

// Shown in other sections.
constexpr std::array<std::string_view, 3> elsewhere{"ground", "rel", "res"};

double threshold_of(const KnownMap& map, const RunRecord& run) {
  if (map.threshold == Threshold::none) return 0;
  if (map.threshold == Threshold::little) return 0.01;
  return run.described() ? wet_depth(run.described()->numerics.spacing) : 0.05;
}

std::string with_unit(const std::string& quantity, RunRecord& run, const std::string& name) {
  const MapRecord* map = run.map(name);
  return map && !map->unit.empty() ? fmt::format("{} [{}]", quantity, map->unit) : quantity;
}

}  // namespace

void add_maps(Report& report) {
  const auto& [run, other, say, page, sharpness] = report;
  page.section(say("map.title"));
  page.text(say("map.about"));
  add_map_key(report);
  std::vector<std::string> names = run.map_names();
  for (const KnownMap& map : known_maps) {
    const std::string name(map.name);
    const bool is_there = std::erase(names, name) > 0;
    if (is_there || map.is_expected)
      add_map(report, name,
              {say("map." + name), with_unit(say("quantity." + name), run, name),
               threshold_of(map, run)});
  }
  for (const std::string_view name : elsewhere) std::erase(names, name);
  for (const std::string& name : names) add_map(report, name, {name, with_unit(name, run, name)});
}

}  // namespace sabo
