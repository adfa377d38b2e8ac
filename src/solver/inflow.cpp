#include "solver/inflow.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace sabo {
namespace {

constexpr double golden = 0.6180339887498949;  // additive recurrences of low discrepancy
constexpr double plastic = 0.7548776662466927;
constexpr double room = 0.7;  // spacings that a place needs to the nearest particle

double fraction(double x) { return x - std::floor(x); }

/// Places of a section in the order in which a level fills them.
class FillingOrder {
 public:
  FillingOrder(const InflowPlan& plan, std::uint64_t layer) : plan_(plan) {
    const std::vector<Vec3d>& columns = plan.section.columns();
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const double shift =
          fraction(static_cast<double>(k) * golden + static_cast<double>(layer) * plastic) - 0.5;
      lowest_.emplace(columns[k].z + (0.5 + shift) * plan.spacing, k, 0);
    }
  }

  /// Column and number above the bed, from 0.
  std::pair<std::size_t, std::size_t> next() {
    const auto [key, column, number] = lowest_.top();
    lowest_.pop();
    lowest_.emplace(key + plan_.spacing, column, number + 1);
    return {column, number};
  }

 private:
  using Place = std::tuple<double, std::size_t, std::size_t>;  // key, column, number above the bed

  const InflowPlan& plan_;
  std::priority_queue<Place, std::vector<Place>, std::greater<>> lowest_;
};

}  // namespace

SectionFlow InflowPlan::flow_at(double time) const {
  const double discharge = hydrograph.discharge_at(time);
  if (!(discharge > 0)) return {section.lowest(), 0, 0, 0, 0};
  return hydrograph.speed.empty() ? section.at_froude(discharge, froude, gravity)
                                  : section.at_speed(discharge, hydrograph.speed_at(time));
}

SectionFlow InflowPlan::flow_at_peak() const { return flow_at(hydrograph.time[hydrograph.peak()]); }

SectionFlow InflowPlan::highest_flow() const {
  if (hydrograph.speed.empty()) return flow_at_peak();
  std::size_t highest = hydrograph.peak();
  const auto area = [&](std::size_t k) { return hydrograph.discharge[k] / hydrograph.speed[k]; };
  for (std::size_t k = 0; k < hydrograph.time.size(); ++k)
    if (hydrograph.discharge[k] > 0 && area(k) > area(highest)) highest = k;
  return flow_at(hydrograph.time[highest]);
}

std::size_t InflowPlan::particles_until(double time) const {
  return static_cast<std::size_t>(std::llround(hydrograph.volume_until(time) / particle_volume()));
}

double InflowPlan::speed_at(double time) const {
  if (!hydrograph.speed.empty()) return hydrograph.speed_at(time);
  return std::max(flow_at(time).speed, section.froude_speed(spacing, froude, gravity));
}

Inflow::Inflow(const InflowPlan& plan, std::uint16_t number) : plan_(plan), number_(number) {
  if (plan.hydrograph.discharge_at(0) > 0) advance_ = plan.speed_at(0) * plan.section.cosine();
}

double Inflow::entered() const { return static_cast<double>(count_) * plan_.particle_volume(); }

/// Particles that the hydrograph has brought and that have not come yet.
double Inflow::owed(double time) const {
  return plan_.hydrograph.volume_until(time) / plan_.particle_volume() -
         static_cast<double>(count_);
}

bool Inflow::is_over(double time) const {
  return time >= plan_.hydrograph.end() && driven_ == 0 && owed(time) < 0.5;
}

/// A layer comes less than a spacing beyond the line.
bool Inflow::may_be_in_the_way(const Vec3d& place) const {
  return std::abs(plan_.section.distance(place)) < (1 + room) * plan_.spacing;
}

Inflow::Change Inflow::advance(Particles& fluid, const Tait& state, double time, double dt,
                               std::uint32_t& next_id) {
  const bool was_active = advance_ > 0;
  if (driven_ > 0) follow_bed(fluid, dt);
  const bool is_due = layer_is_due(dt);
  moved_ += dt * advance_;
  Change change;
  if (is_due) {
    moved_ = std::fmod(moved_, plan_.spacing);
    change.freed = set_free(fluid);
    const auto count = static_cast<std::size_t>(std::max(0.0, std::round(owed(time))));
    if (count > 0) add_layer(fluid, state, count, next_id);
    change.entered.resize(count);
    std::iota(change.entered.begin(), change.entered.end(),
              static_cast<std::uint32_t>(fluid.size() - count));
  }
  const bool is_active =
      plan_.hydrograph.discharge_at(time) > 0 || driven_ > 0 || owed(time) >= 0.5;
  advance_ = is_active ? plan_.speed_at(time) * plan_.section.cosine() : 0;
  if (is_active && !was_active) moved_ = 0;
  if (driven_ > 0) set_velocity(fluid);
  return change;
}

/// The step has moved them straight on; they keep their height above the bed.
void Inflow::follow_bed(Particles& fluid, double dt) const {
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    if (fluid.driven[i] != number_) continue;
    Vec3d& x = fluid.position[i];
    const Vec3d before = x - dt * fluid.velocity[i];
    x.z = plan_.section.bed(x) + before.z - plan_.section.bed(before);
  }
}

std::vector<std::uint32_t> Inflow::set_free(Particles& fluid) {
  std::vector<std::uint32_t> freed;
  driven_ = 0;  // counted anew: some may have left the map
  for (std::uint32_t i = 0; i < fluid.size(); ++i) {
    if (fluid.driven[i] != number_) continue;
    if (plan_.section.distance(fluid.position[i]) < plan_.reach) {
      ++driven_;
      continue;
    }
    fluid.driven[i] = 0;
    freed.push_back(i);
  }
  return freed;
}

void Inflow::add_layer(Particles& fluid, const Tait& state, std::size_t count,
                       std::uint32_t& next_id) {
  const InflowSection& section = plan_.section;
  std::vector<Vec3d> taken;  // by what has backed up to the line
  for (std::size_t i = 0; i < fluid.size(); ++i)
    if (fluid.driven[i] == 0 &&
        std::abs(section.distance(fluid.position[i]) - moved_) < room * plan_.spacing)
      taken.push_back(fluid.position[i]);
  const auto is_taken = [&](const Vec3d& place) {
    return std::ranges::any_of(
        taken, [&](const Vec3d& x) { return norm(x - place) < room * plan_.spacing; });
  };

  const double level =
      section.level_of(static_cast<double>(count) * section.column_width() * plan_.spacing);
  const double depth = std::max(level - section.lowest(), plan_.spacing);
  const double weight =
      plan_.density * plan_.gravity * section.cosine() * section.cosine();  // Pa/m
  FillingOrder places(plan_, layers_);
  std::size_t row = fluid.size();
  fluid.resize(row + count);
  while (row < fluid.size()) {
    const auto [column, number] = places.next();
    Vec3d place = section.columns()[column] + moved_ * section.direction();
    place.z = section.bed(place) + (static_cast<double>(number) + 0.5) * plan_.spacing;
    if (is_taken(place)) continue;
    const double above_bed = place.z - section.bed(place);
    const double cover = level - section.columns()[column].z - above_bed;
    fluid.position[row] = place;
    fluid.density[row] = state.density(weight * std::max(0.0, cover));
    fluid.mass[row] = plan_.density * plan_.particle_volume();
    fluid.id[row] = next_id++;
    fluid.shear_rate[row] = advance_ / section.cosine() / depth;
    fluid.driven[row] = number_;
    ++row;
  }
  count_ += count;
  driven_ += count;
  ++layers_;
}

void Inflow::set_velocity(Particles& fluid) const {
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    if (fluid.driven[i] != number_) continue;
    const double rise = plan_.section.rise_at(fluid.position[i]);
    fluid.velocity[i] = advance_ * (plan_.section.direction() + Vec3d{0, 0, rise});
  }
}

}  // namespace sabo
