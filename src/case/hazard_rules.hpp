#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/colour.hpp"
#include "base/describe.hpp"

namespace sabo {

/// What a rule may look at. All but the deposit are greatest values of a cell over the run, taken
/// one by one: a product of two of them is never less than the greatest product.
enum class HazardQuantity {
  depth,             ///< m
  deposit,           ///< depth at the end, m
  speed,             ///< m/s
  depth_speed,       ///< depth x speed, m2/s
  energy_head,       ///< depth + speed^2 / 2 g, m
  momentum_flux,     ///< density x depth x speed^2, of the map pmf, kN/m
  pressure,          ///< in the column of the flow, kPa
  impact,            ///< density x speed^2, kPa
  impact_over_house  ///< impact over the strength of an ordinary house
};
template <>
struct Words<HazardQuantity> {
  static constexpr std::array<std::string_view, 9> list{
      "depth",         "deposit",  "speed",  "depth_speed",      "energy_head",
      "momentum_flux", "pressure", "impact", "impact_over_house"};
};

/// A quantity that is greater than a threshold.
struct HazardCondition {
  HazardQuantity quantity = HazardQuantity::depth;
  double above = 0;
};

/// A class of intensity or a level of hazard.
struct HazardClass {
  std::string name;
  std::string label;
  Colour colour{};
  /// A cell is in the class when all conditions of one of these lists hold; without a list every
  /// wet cell is. Not used for levels.
  std::vector<std::vector<HazardCondition>> when = {};
};

/// Strength of an ordinary house against a flow of height H (m): a / (H (b - H)), kPa. From its
/// least value at H = b/2 on it stays there: the formula, of the bending of a wall, rises again.
struct HouseStrength {
  double a = 0;  ///< kPa m2
  double b = 0;  ///< m

  double at(double height) const {
    const double h = height < b / 2 ? height : b / 2;
    return a / (h * (b - h));
  }
};

/// Level of hazard by class and return period.
struct HazardMatrix {
  std::vector<double> return_periods;    ///< years, rising: the greatest one of each column
  std::vector<std::vector<int>> levels;  ///< by class and column: an index of HazardRules::levels
  std::optional<int> beyond;             ///< level of longer return periods; none without
};

/// Rules that turn maps into classes of hazard.
struct HazardRules {
  std::string name;
  std::string source;
  std::string caution;
  double wet_depth = 0;              ///< m, above which a cell counts; 0 for that of the run
  std::vector<HazardClass> classes;  ///< from the worst to the least
  std::vector<HazardClass> levels;   ///< from the worst to the least; with a matrix only
  std::optional<HouseStrength> house;
  std::optional<HazardMatrix> matrix;
};

}  // namespace sabo
