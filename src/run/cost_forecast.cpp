#include "run/cost_forecast.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <vector>

#include <fmt/format.h>
#include <omp.h>

#include "base/error.hpp"
#include "base/host_loops.hpp"
#include "run/flow.hpp"
#include "run/memory_estimate.hpp"

namespace sabo {
namespace {

constexpr double ground_weight = 0.25;  // time of a ground particle over that of one of the flow
constexpr double mean_over_top =
    1.0 / 3;                         // of the fastest speed over a run: most of it is spent slow
constexpr double fastest_flow = 30;  // m/s; debris flows are rarely faster
constexpr double wall_limit = 1.2;   // s of measuring
constexpr double share_of_duration = 0.02;
constexpr std::size_t most_stepped = 100000;  // that are stepped: half a second a list or less

/// The acoustic time step at a speed, s.
double acoustic_step(const CostOutlook& o, double sound, double speed) {
  return o.method == Method::paper ? o.cfl * o.h / std::max(sound, 10 * speed)
                                   : o.cfl * o.h / (sound + speed);
}

double expected_step(const CostSample& sample, const CostOutlook& o, double speed) {
  const double sound = std::max(o.slowest_sound, o.sound_factor * speed);
  const double later = acoustic_step(o, sound, speed);
  const bool was_acoustic = sample.dt > 0.95 * acoustic_step(o, sample.sound_speed, sample.speed);
  return was_acoustic ? later : std::min(sample.dt, later);
}

/// The particles nearest to the centre of the release.
Particles part_of(const Particles& all, const Vec3d& centre, std::size_t count) {
  std::vector<std::uint32_t> order(all.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto distance = [&](std::uint32_t i) {
    return std::hypot(all.position[i].x - centre.x, all.position[i].y - centre.y);
  };
  std::nth_element(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end(),
                   [&](auto a, auto b) { return distance(a) < distance(b); });
  order.resize(count);
  Particles part;
  part.append(all, order);
  return part;
}

/// Particles that stand in front of an inflow, or as many as `most`, if it flows on as at its peak.
Particles flow_before(const InflowPlan& inflow, const Surface& surface, std::size_t most) {
  const SectionFlow peak = inflow.flow_at_peak();
  const InflowSection& section = inflow.section;
  Particles flow;
  std::size_t before = 0;
  for (int layer = 0; flow.size() < most && (layer == 0 || flow.size() > before); ++layer) {
    before = flow.size();
    for (const Vec3d& column : section.columns()) {
      Vec3d place = column + (layer * inflow.spacing) * section.direction();
      if (!surface.inside(place.x, place.y)) continue;
      const double bed = section.bed(place);
      for (double above = inflow.spacing / 2; column.z + above < peak.level;
           above += inflow.spacing) {
        place.z = bed + above;
        flow.resize(flow.size() + 1);
        flow.position.back() = place;
        flow.velocity.back() = peak.speed * section.cosine() * section.direction();
        flow.density.back() = inflow.density;
        flow.mass.back() = inflow.density * inflow.particle_volume();
        flow.id.back() = static_cast<std::uint32_t>(flow.size() - 1);
      }
    }
  }
  return flow;
}

Particles sample_of(const Case& c, const Scene& scene) {
  if (scene.release.size() == 0)
    return flow_before(scene.inflows.front(), *scene.surface,
                       std::min(most_stepped, scene.particles_until(c.run.duration)));
  return scene.release.size() > most_stepped
             ? part_of(scene.release, scene.release_centre, most_stepped)
             : scene.release;
}

/// Particles of the flow, mean over the run: those of inflows come one by one.
std::size_t mean_particles(const Case& c, const Scene& scene) {
  constexpr int samples = 100;
  double sum = 0;
  for (int k = 0; k < samples; ++k)
    sum += static_cast<double>(scene.particles_until(c.run.duration * (k + 0.5) / samples));
  return static_cast<std::size_t>(std::max(1.0, sum / samples));
}

bool makes_lists(const PassTime& pass) {
  return pass.name == "neighbour search" || pass.name == "sort" || pass.name == "ground";
}

/// What making lists has taken, s: all of them, and one.
struct ListTime {
  double all = 0;
  double one = 0;
};

ListTime list_time(const PassTimes& times) {
  ListTime time;
  for (const PassTime& pass : times.passes()) {
    if (!makes_lists(pass)) continue;
    time.all += pass.seconds;
    time.one += pass.seconds / static_cast<double>(pass.calls);
  }
  return time;
}

/// What three of four are above: other programs only ever add time, and may be gone tomorrow.
double lower_quartile(std::vector<double> values) {
  const auto quarter = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 4);
  std::nth_element(values.begin(), quarter, values.end());
  return *quarter;
}

CostSample measure(Flow& flow, double duration) {
  using Clock = std::chrono::steady_clock;
  const auto seconds_since = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  // Asked for anew each time: a backend may count passes only then.
  const auto lists = [&] { return list_time(flow.backend().pass_times()); };
  // The first step does not count: it touches all memory anew.
  StepReport report = flow.stepper().step();
  std::vector<double> steps;  // without their lists, s
  const auto start = Clock::now();
  do {
    const auto before = Clock::now();
    const double before_step = lists().all;
    report = flow.stepper().step();
    steps.push_back(seconds_since(before) - (lists().all - before_step));
  } while (seconds_since(start) < wall_limit &&
           flow.stepper().time() < share_of_duration * duration);

  CostSample sample;
  sample.list_seconds = lists().one;
  sample.step_seconds = lower_quartile(steps);
  sample.fluid = flow.backend().fluid_count();
  sample.boundary = flow.backend().boundary_count();
  sample.dt = report.dt;
  sample.speed = report.flow.speed;
  sample.sound_speed = report.sound_speed;
  return sample;
}

std::string steps_text(double steps) {
  return steps < 1e4 ? fmt::format("{:.0f}", steps) : fmt::format("{:.3g} thousand", steps / 1e3);
}

}  // namespace

CostForecast forecast(const CostSample& sample, const CostOutlook& outlook) {
  const double speed = std::max(sample.speed, mean_over_top * outlook.top_speed);
  CostForecast result;
  result.dt = expected_step(sample, outlook, speed);
  result.steps = std::ceil(outlook.duration / result.dt);

  // Of the part that was stepped, the ground grows as that of the whole.
  const auto fluid = static_cast<double>(sample.fluid);
  const auto ground = static_cast<double>(sample.boundary);
  const double part = fluid / static_cast<double>(outlook.fluid);
  const double mean_ground = 0.5 * (ground + std::max(ground, part * outlook.latest_ground));
  const double growth = (fluid + ground_weight * mean_ground) / (fluid + ground_weight * ground);
  const double steps_per_list = std::max(1.0, outlook.list_reach / (speed * result.dt));
  const double step = sample.step_seconds + sample.list_seconds / steps_per_list;
  result.seconds = result.steps * step * growth / part;
  return result;
}

double speed_bound(const Case& c, const Scene& scene) {
  const double given = c.numerics.reference_speed;
  const double run = length(scene.path);
  const auto height = [&](double station) {
    const Vec3d at = point_at(scene.path, station);
    return scene.surface->height(at.x, at.y);
  };
  if (!(run > 0)) return given;
  const double friction = has_yield(c.material.law) ? c.material.yield.slope() : 0;
  constexpr int samples = 200;
  double head = 0;
  for (int k = 1; k <= samples; ++k) {
    const double station = run * k / samples;
    head = std::max(head, height(0) - height(station) - friction * station);
  }
  const double sliding = std::min(fastest_flow, std::sqrt(2 * c.numerics.gravity * head));
  return given > 0 ? std::min(given, sliding) : sliding;
}

CostForecast measured_forecast(const Case& c, const Scene& scene) {
  // Programs that wanted to run during the last minute; this one is not yet among them.
  double load = 0;
  if (getloadavg(&load, 1) != 1) load = 0;
  Flow flow(c, scene, sample_of(c, scene));
  const FlowModel& model = flow.model();
  const bool is_fast = c.numerics.method == Method::fast;
  CostOutlook outlook;
  outlook.method = c.numerics.method;
  outlook.duration = c.run.duration;
  outlook.h = model.h;
  outlook.cfl = c.numerics.cfl;
  outlook.slowest_sound = model.state.c0;
  if (is_fast && c.numerics.adaptive_sound_speed)
    outlook.sound_factor = c.numerics.sound_speed_factor;
  outlook.list_reach = flow.backend().list_radius() - model.kernel_radius();
  // There a list lasts until two particles may have moved against each other by its skin.
  const bool on_card = c.numerics.backend == BackendKind::cuda;
  if (on_card) outlook.list_reach /= 2;
  outlook.top_speed = speed_bound(c, scene);
  outlook.fluid = mean_particles(c, scene);
  outlook.latest_ground = expected_boundary(model, scene.particles_until(c.run.duration));
  if (!(outlook.fluid > 0) || flow.backend().fluid_count() == 0)
    throw RunError("there is no flow to step");
  CostForecast result = forecast(measure(flow, c.run.duration), outlook);
  result.threads = host_threads(model.threads);
  result.on_card = on_card;
  result.is_busy = load + result.threads > omp_get_num_procs() + 0.5;
  return result;
}

std::string forecast_text(const CostForecast& forecast) {
  const double s = forecast.seconds;
  const auto [unit, name] = s < 90       ? std::pair{1.0, "s"}
                            : s < 5400   ? std::pair{60.0, "min"}
                            : s < 172800 ? std::pair{3600.0, "h"}
                                         : std::pair{86400.0, "days"};
  const auto number = [u = unit](double seconds) {
    return seconds < 9.5 * u ? fmt::format("{:.1g}", seconds / u)
                             : fmt::format("{:.0f}", seconds / u);
  };
  const std::string on = forecast.on_card ? "the graphics card"
                                          : fmt::format("{} thread{}", forecast.threads,
                                                        forecast.threads == 1 ? "" : "s");
  return fmt::format("about {} {} on {} ({} to {} {}), {} steps of {:.2g} ms", number(s), name, on,
                     number(s / forecast_factor), number(s * forecast_factor), name,
                     steps_text(forecast.steps), 1e3 * forecast.dt) +
         (forecast.is_busy ? "; uncertain, for other programs run beside it" : "");
}

}  // namespace sabo
