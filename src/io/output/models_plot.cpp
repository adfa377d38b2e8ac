#include "io/output/models_plot.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/error.hpp"

namespace sabo {
namespace {

constexpr double slowest = 1e-4;  // 1/s
constexpr double fastest = 1e3;
constexpr int steps_per_decade = 40;

double viscosity(const Rheology& law, const Shear& at) {
  return std::visit([&](const auto& l) { return l.viscosity(at); }, law);
}

ChartSeries curve(const Rheology& law, Shear at, const std::function<double(const Shear&)>& value) {
  ChartSeries series{std::string(name_of(law))};
  const int steps = static_cast<int>(std::lround(std::log10(fastest / slowest) * steps_per_decade));
  for (int k = 0; k <= steps; ++k) {
    at.rate = slowest * std::pow(10, static_cast<double>(k) / steps_per_decade);
    series.x.push_back(at.rate);
    series.y.push_back(value(at));
  }
  return series;
}

}  // namespace

ModelsPlot plot_models(const std::vector<Rheology>& laws, const Shear& at,
                       const std::string& conditions) {
  if (laws.empty()) throw CaseError("--laws", "there is no law to draw", "name one or more");
  LineChart viscosities{"Effective viscosity: " + conditions, "shear rate [1/s]",
                        "effective viscosity [Pa s]"};
  LineChart stresses{"Shear stress: " + conditions, "shear rate [1/s]", "shear stress [Pa]"};
  for (const Rheology& law : laws) {
    viscosities.series.push_back(curve(law, at, [&](const Shear& s) { return viscosity(law, s); }));
    stresses.series.push_back(
        curve(law, at, [&](const Shear& s) { return viscosity(law, s) * s.rate; }));
  }
  viscosities.x_log = viscosities.y_log = stresses.x_log = true;
  if (at.yield_stress > 0) {
    stresses.y_high = 3 * at.yield_stress;
    stresses.references.push_back({at.yield_stress, "yield stress"});
    for (ChartSeries& series : stresses.series) {
      const auto beyond =
          std::ranges::find_if(series.y, [&](double stress) { return stress > *stresses.y_high; });
      series.x.resize(static_cast<std::size_t>(beyond - series.y.begin()));
      series.y.resize(series.x.size());
    }
  }
  for (LineChart* chart : {&viscosities, &stresses}) {
    chart->width = 900;
    chart->height = 520;
  }
  return {std::move(viscosities), std::move(stresses)};
}

}  // namespace sabo
