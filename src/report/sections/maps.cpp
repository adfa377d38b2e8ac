#include <algorithm>
#include <array>
#include <string_view>

#include "report/report_maps.hpp"
#include <fmt/format.h>

#include "run/run_maps.hpp"

namespace sabo {
namespace {

struct KnownMap {
  std::string_view name;
  bool is_expected;  ///< every run has it
};

// In the order of the report.
constexpr std::array known_maps{
    KnownMap{"pfd", true},  KnownMap{"pfv", true},  KnownMap{"ppr", true}, KnownMap{"pmf", false},
    KnownMap{"pft", false}, KnownMap{"tarr", true}, KnownMap{"dep", true}, KnownMap{"det", false}};

// Shown in other sections.
constexpr std::array<std::string_view, 3> elsewhere{"ground", "rel", "res"};

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
               map_kind(name)->threshold(wet_depth_of(run))});
  }
  for (const std::string_view name : elsewhere) std::erase(names, name);
  for (const std::string& name : names) add_map(report, name, {name, with_unit(name, run, name)});
}

}  // namespace sabo
