#include "run/section_states.hpp"

#include <array>

#include "run/series_header.hpp"

namespace sabo {
namespace {

std::vector<std::string> section_columns(const Scene& scene) {
  std::vector<std::string> names{"time [s]"};
  for (const NamedSection& section : scene.sections)
    add_columns(names, section.name,
                {"area [m2]", "greatest depth [m]", "mean speed [m/s]", "greatest speed [m/s]"});
  return names;
}

}  // namespace

SectionStates::SectionStates(const Scene& scene, const FlowModel& model, const RunFolder& folder)
    : scene_(scene),
      sections_csv_(folder.series_file("sections.csv"), section_columns(scene)),
      profiles_csv_(folder.series_file("velocity_profiles.csv"),
                    {"section", "time [s]", "height [m]", "area [m2]", "speed [m/s]"}) {
  for (const NamedSection& section : scene.sections)
    slabs_.emplace_back(section.line, model.spacing, model.state.rho0);
}

void SectionStates::write_row(double time, const Particles& fluid) {
  std::vector<double> row{time};
  for (std::size_t k = 0; k < slabs_.size(); ++k) {
    const SectionState state = slabs_[k].measure(*scene_.surface, fluid);
    row.insert(row.end(), {state.area, state.depth, state.mean_speed, state.greatest_speed});
    for (const SectionState::Layer& layer : state.layers)
      profiles_csv_.append(scene_.sections[k].name,
                           std::array{time, layer.height, layer.area, layer.speed});
  }
  sections_csv_.append(row);
}

}  // namespace sabo
