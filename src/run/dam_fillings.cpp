#include "run/dam_fillings.hpp"

#include "run/series_header.hpp"

namespace sabo {
namespace {

std::vector<std::string> filling_columns(const Scene& scene) {
  std::vector<std::string> names{"time [s]"};
  for (const CheckDam& dam : scene.check_dams())
    add_columns(names, dam.name, {"stored [m3]", "filled [1]", "surface [m]"});
  return names;
}

}  // namespace

Basin basin_behind(const CheckDam& dam, const Scene& scene) {
  return {scene.surface->elevation(), dam, scene.side_of_release(dam)};
}

DamFillings::DamFillings(const Scene& scene, const RunFolder& folder)
    : csv_(folder.series_file("filling.csv"), filling_columns(scene)) {
  for (const CheckDam& dam : scene.check_dams()) basins_.push_back(basin_behind(dam, scene));
}

std::vector<BasinState> DamFillings::write_row(double time, const Columns& columns) {
  std::vector<BasinState> states;
  std::vector<double> row{time};
  for (const Basin& basin : basins_) {
    states.push_back(basin.measure(columns));
    row.insert(row.end(), {states.back().stored, states.back().filled, states.back().surface});
  }
  csv_.append(row);
  return states;
}

}  // namespace sabo
