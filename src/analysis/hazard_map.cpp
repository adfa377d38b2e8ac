#include "analysis/hazard_map.hpp"

#include <algorithm>
#include <cmath>

namespace sabo {
namespace {

constexpr double gravity = 9.81;  // m/s2

double value_at(HazardQuantity quantity, const HazardRules& rules, const HazardMaps& maps,
                std::size_t cell) {
  const auto at = [&](HazardQuantity which) { return maps.at(which).values[cell]; };
  switch (quantity) {
    case HazardQuantity::depth_speed:
      return at(HazardQuantity::depth) * at(HazardQuantity::speed);
    case HazardQuantity::energy_head:
      return at(HazardQuantity::depth) +
             at(HazardQuantity::speed) * at(HazardQuantity::speed) / (2 * gravity);
    case HazardQuantity::impact_over_house:
      return at(HazardQuantity::impact) / rules.house->at(at(HazardQuantity::depth));
    default:
      return at(quantity);
  }
}

bool holds(const HazardClass& wanted, const HazardRules& rules, const HazardMaps& maps,
           std::size_t cell) {
  const auto is_met = [&](const HazardCondition& condition) {
    return value_at(condition.quantity, rules, maps, cell) > condition.above;  // false for NaN
  };
  const auto are_met = [&](const std::vector<HazardCondition>& all) {
    return std::ranges::all_of(all, is_met);
  };
  return wanted.when.empty() || std::ranges::any_of(wanted.when, are_met);
}

}  // namespace

std::set<HazardQuantity> quantities_of(const HazardRules& rules) {
  std::set<HazardQuantity> needed{HazardQuantity::depth};
  for (const HazardClass& one : rules.classes) {
    for (const auto& all : one.when) {
      for (const HazardCondition& condition : all) {
        if (condition.quantity == HazardQuantity::depth_speed ||
            condition.quantity == HazardQuantity::energy_head) {
          needed.insert(HazardQuantity::speed);
        } else if (condition.quantity == HazardQuantity::impact_over_house) {
          needed.insert(HazardQuantity::impact);
        } else {
          needed.insert(condition.quantity);
        }
      }
    }
  }
  return needed;
}

Raster classify(const HazardRules& rules, const HazardMaps& maps, double wet) {
  const Raster& depth = maps.at(HazardQuantity::depth);
  Raster classes(depth.grid, Raster::no_data);
  for (std::size_t cell = 0; cell < depth.values.size(); ++cell) {
    if (!(depth.values[cell] > wet)) continue;
    const auto found = std::ranges::find_if(
        rules.classes, [&](const HazardClass& one) { return holds(one, rules, maps, cell); });
    if (found != rules.classes.end())
      classes.values[cell] = static_cast<double>(rules.classes.end() - found);
  }
  return classes;
}

Raster levels_of(const Raster& classes, const HazardRules& rules, double return_period) {
  const HazardMatrix& matrix = *rules.matrix;
  const auto column = std::ranges::find_if(
      matrix.return_periods, [return_period](double end) { return return_period <= end; });
  Raster levels(classes.grid, Raster::no_data);
  for (std::size_t cell = 0; cell < classes.values.size(); ++cell) {
    if (std::isnan(classes.values[cell])) continue;
    const std::size_t row = rules.classes.size() - static_cast<std::size_t>(classes.values[cell]);
    std::optional<int> level = matrix.beyond;
    if (column != matrix.return_periods.end())
      level = matrix.levels[row][column - matrix.return_periods.begin()];
    if (level) levels.values[cell] = static_cast<double>(rules.levels.size()) - *level;
  }
  return levels;
}

void take_worse(const Raster& other, Raster& worst) {
  for (std::size_t cell = 0; cell < worst.values.size(); ++cell)
    worst.values[cell] = std::fmax(worst.values[cell], other.values[cell]);
}

}  // namespace sabo
