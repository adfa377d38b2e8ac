#include "run/load_text.hpp"

#include <cmath>

#include <fmt/format.h>

#include "io/case_file/toml_string.hpp"
#include "run/amount_text.hpp"

namespace sabo {
namespace {

std::string kilo(double value) { return amount_text(value / 1000); }

std::string triple(const Vec3d& v) {
  return fmt::format("[{:.9g}, {:.9g}, {:.9g}]", v.x, v.y, v.z);
}

}  // namespace

std::string loads_toml(const std::vector<LoadSummary>& loads, const LoadCase& settings) {
  std::string text;
  for (const LoadSummary& load : loads)
    text += fmt::format(
        "\n[[load]]  # N, N m, N s; moments about the middle of the base\nname = {}\n"
        "peak_force = {:.9g}\npeak_time = {:.6g}\nfilter = {:g}\nimpulse = {}\n"
        "hydrostatic = {:.9g}\ndynamic = {:.9g}\nalpha = {:g}\n"
        "row_time = {:.6g}\nrow_force = {}\nrow_moment = {}\n",
        toml_string(load.name), load.peak, load.peak_time, settings.filter, triple(load.impulse),
        load.hydrostatic, load.dynamic, settings.alpha, load.row_time, triple(load.row_force),
        triple(load.row_moment));
  return text;
}

PageTable load_table(const std::vector<LoadSummary>& loads, const LoadCase& settings) {
  PageTable table;
  table.caption = fmt::format("Greatest horizontal forces, means over {:g} s", settings.filter);
  table.header = {"",
                  "force [kN]",
                  "at [s]",
                  "tilting moment [kN m]",
                  "impulse [kN s]",
                  "½ ρ g h² [kN]",
                  fmt::format("{:g} ρ h v² [kN]", settings.alpha)};
  for (const LoadSummary& load : loads)
    table.rows.push_back({load.name, kilo(load.peak), fmt::format("{:.1f}", load.peak_time),
                          kilo(std::hypot(load.row_moment.x, load.row_moment.y)),
                          kilo(std::hypot(load.impulse.x, load.impulse.y)), kilo(load.hydrostatic),
                          kilo(load.dynamic)});
  return table;
}

}  // namespace sabo
