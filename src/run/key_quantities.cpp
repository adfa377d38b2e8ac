#include "run/key_quantities.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/arrival.hpp"

namespace sabo {
namespace {

/// Greatest value over the rows, at least 0.
template <class Value>
double greatest(const std::vector<SeriesRow>& rows, const Value& value) {
  double result = 0;
  for (const SeriesRow& row : rows) result = std::max(result, value(row));
  return result;
}

void add_arrival(const RunMaps& maps, const std::string& name, const Polyline& line,
                 double half_width, std::vector<KeyQuantity>& list) {
  if (const auto time = first_arrival(maps.arrival, line, half_width))
    list.push_back({"arrival at " + name, "s", *time});
}

/// What a section is called here: a dam may have the same name.
std::string name_of_section(const std::string& name, const Scene& scene) {
  const bool is_taken =
      std::ranges::any_of(scene.dams, [&name](const CheckDam& dam) { return dam.name == name; });
  return is_taken ? "section " + name : name;
}

void add_deposit(const Raster& depth, double wet, std::vector<KeyQuantity>& list) {
  double cells = 0;
  double sum = 0;
  for (const double value : depth.values) {
    if (!(value > wet)) continue;
    cells += 1;
    sum += value;
  }
  list.push_back({"deposit area", "m2", cells * depth.grid.cell_area()});
  list.push_back({"deposit mean depth", "m", cells > 0 ? sum / cells : 0});
}

}  // namespace

std::vector<KeyQuantity> key_quantities(const RunMaps& maps, const std::vector<SeriesRow>& rows,
                                        const Scene& scene) {
  if (rows.empty()) return {};
  const SeriesRow& last = rows.back();
  const Grid& grid = maps.arrival.grid;
  std::vector<KeyQuantity> list;
  // What has left the map is no longer a front.
  const auto displacement = [](const SeriesRow& row) { return row.front.displacement; };
  list.push_back({"front run-out", "m",
                  last.left.mass > 0 ? greatest(rows, displacement) : displacement(last)});
  list.push_back({"peak front speed", "m/s",
                  greatest(rows, [](const SeriesRow& row) { return row.front.velocity; })});
  for (std::size_t k = 0; k < scene.dams.size(); ++k) {
    const CheckDam& dam = scene.dams[k];
    // The flow stands before the dam, not on its axis.
    add_arrival(maps, dam.name, dam.axis, dam.thickness / 2 + std::max(grid.dx, grid.dy), list);
    if (k >= scene.check_dams().size()) continue;
    list.push_back({"trapped by " + dam.name, "m3", last.volumes[k].trapped});
    list.push_back({"beyond " + dam.name, "m3", last.volumes[k].beyond});
    list.push_back({"stored in the basin of " + dam.name, "m3", last.basins[k].stored});
  }
  for (std::size_t k = 0; k < scene.sections.size(); ++k) {
    const std::string name = name_of_section(scene.sections[k].name, scene);
    add_arrival(maps, name, scene.sections[k].line, 0, list);
    list.push_back({"peak discharge at " + name, "m3/s", greatest(rows, [k](const SeriesRow& row) {
                      return std::abs(row.discharge[k]);
                    })});
  }
  list.push_back({"left the map", "m3", last.volumes.front().outflow});
  add_deposit(maps.deposit, maps.wet_depth, list);
  return list;
}

}  // namespace sabo
