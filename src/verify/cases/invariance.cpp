// A column of debris slumps on a floor, in two dimensions. Where the flow stands, how it is turned
// with its gravity, by what backend and with how many threads it is computed must not matter; nor,
// to first order, the speed of sound, which only has to be large. For a single step the results
// agree to rounding; later they scatter, and means over jittered starts are compared.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "verify/cases.hpp"
#include <fmt/format.h>

#include "analysis/convergence.hpp"
#include "solver/lattice.hpp"
#include "solver/make_backend.hpp"
#include "solver/make_stepper.hpp"

namespace sabo {
namespace {

constexpr double spacing = 0.1;  // m
constexpr int cells = 14;        // of the column, along each axis
constexpr int reach = 60;        // of the floor, in cells to either side

/// A way to look at the same flow.
struct View {
  std::string name;
  double angle = 0;  ///< by which geometry and gravity are turned about y, rad
  Vec3d shift = {};  ///< m
  BackendKind backend = BackendKind::cpu;
  double sound_speed_factor = 10;
  int threads = 1;

  Vec3d turned(const Vec3d& v) const {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * v.x + s * v.z, v.y, -s * v.x + c * v.z};
  }
  Vec3d turned_back(const Vec3d& v) const {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * v.x - s * v.z, v.y, s * v.x + c * v.z};
  }
  Vec3d placed(const Vec3d& x) const { return turned(x) + shift; }
  Vec3d place(const Vec3d& x) const { return turned_back(x - shift); }
};

/// The column, seen so; each start displaces its particles by other random numbers.
class Slump {
 public:
  Slump(const View& view, const VerifySettings& settings, int seed) : view_(view) {
    NumericsCase numerics = settings.numerics();
    numerics.spacing = spacing;
    numerics.threads = view.threads;
    numerics.sound_speed_factor = view.sound_speed_factor;
    // Conjugate gradients end at this share of dt g, each component of velocity for itself: to see
    // rounding alone it has to be small.
    numerics.viscous_tolerance = 1e-7;
    MaterialCase material;
    material.density = 1700;
    material.law = Cross{20, 1000, 1};
    material.yield = {0, 25, 0};
    const double depth = cells * spacing;
    FlowModel model = settings.model(material, numerics, depth);
    model.dimension = 2;
    backend_ = make_backend(view.backend, seen(model));
    Particles& fluid = backend_->fluid();
    add_block(fluid, model, {0, cells, 0, 1, 0, cells});
    const double weight = -model.gravity.z * model.state.rho0;
    std::mt19937_64 random(static_cast<std::uint64_t>(seed));
    const auto displacement = [&] {  // the same on every machine
      return 0.1 * spacing * (static_cast<double>(random() >> 11) * 0x1p-53 - 0.5);
    };
    for (std::size_t i = 0; i < fluid.size(); ++i) {
      Vec3d& x = fluid.position[i];
      fluid.density[i] = model.state.density(weight * (depth - x.z));
      x += {displacement(), 0, displacement()};
      x = view.placed(x);
    }
    Particles& floor = backend_->boundary();
    add_block(floor, model, {-reach, cells + reach, 0, 1, -model.wall_layers(), 0});
    for (Vec3d& x : floor.position) x = view.placed(x);
    stepper_ = make_stepper(numerics, *backend_, nullptr);
  }

  void run_to(double time) { stepper_->advance_to(time); }
  void step(double dt) { stepper_->step(dt); }

  /// Velocities as if nothing were turned, in the order in which the particles were made.
  std::vector<Vec3d> velocities() const {
    const Particles& fluid = backend_->fluid();
    std::vector<Vec3d> list(fluid.size());
    for (std::size_t i = 0; i < fluid.size(); ++i)
      list[fluid.id[i]] = view_.turned_back(fluid.velocity[i]);
    return list;
  }

  /// Mean place of the foremost 2 % of the mass, in front of where the column stood, m.
  double front() const {
    std::vector<double> x;
    for (const Vec3d& position : backend_->fluid().position) x.push_back(view_.place(position).x);
    const std::size_t count = x.size() / 50 + 1;
    std::nth_element(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(count), x.end(),
                     std::greater<>());
    double sum = 0;
    for (std::size_t k = 0; k < count; ++k) sum += x[k];
    return sum / static_cast<double>(count) - cells * spacing;
  }

 private:
  FlowModel seen(FlowModel model) const {
    model.gravity = view_.turned(model.gravity);
    return model;
  }

  View view_;
  std::unique_ptr<Backend> backend_;
  std::unique_ptr<Stepper> stepper_;
};

/// Greatest difference of two velocities over the greatest velocity.
double difference(const std::vector<Vec3d>& a, const std::vector<Vec3d>& b) {
  double most = 0, scale = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    most = std::max(most, norm(a[i] - b[i]));
    scale = std::max(scale, norm(a[i]));
  }
  return most / scale;
}

struct Mean {
  double value = 0, error = 0;  ///< and its standard error
};

Mean mean_of(const std::vector<double>& values) {
  const Scatter scatter = scatter_of(values);
  return {scatter.mean, scatter.deviation / std::sqrt(static_cast<double>(values.size()))};
}

void add_single_steps(const View& plain, const std::vector<View>& views,
                      const VerifySettings& settings, Verdict& verdict) {
  Slump first(plain, settings, 1);
  first.step(1e-3);
  for (const View& view : views) {
    Slump other(view, settings, 1);
    other.step(1e-3);
    verdict.claims.push_back(
        Claim::at_most(view.name + ": velocity after a step, greatest difference over greatest", "",
                       difference(first.velocities(), other.velocities()), 1e-5));
  }
}

void add_threads(const VerifySettings& settings, Verdict& verdict) {
  std::vector<std::vector<Vec3d>> results;
  for (const int threads : {1, 2, 4}) {
    View view;
    view.threads = threads;
    Slump slump(view, settings, 1);
    slump.run_to(0.03);
    results.push_back(slump.velocities());
  }
  verdict.claims.push_back(Claim::at_most(
      "1, 2 and 4 threads: difference of velocities after 0.03 s", "",
      std::max(difference(results[0], results[1]), difference(results[0], results[2])), 0));
}

}  // namespace

Verdict verify_invariance(const VerifySettings& settings) {
  const View plain{"as it is"};
  View turned{"turned by 30°"}, far{"10 km away"}, reference{"backend reference"},
      stiff{"twice the speed of sound"};
  turned.angle = std::numbers::pi / 6;
  far.shift = {1e4, 0, 500};
  reference.backend = BackendKind::reference;
  stiff.sound_speed_factor = 20;

  Verdict verdict;
  add_single_steps(plain, {turned, far, reference}, settings, verdict);
  add_threads(settings, verdict);
  if (settings.is_quick()) {
    settings.on_progress(1);
    return verdict;
  }

  // Single fronts scatter by 2 to 4 %: that two means differ by less than 2 % is told by 32 starts,
  // not by 8, which tell whether anything but rounding differs.
  constexpr int few = 8, many = 32;
  const double end = 1.5;  // s; it has come to rest
  LineChart chart{fmt::format("Fronts of {} jittered starts", few), "start", "front [m]"};
  chart.has_zero = false;
  int done = 0;
  const auto fronts_of = [&](const View& view, int members) {
    std::vector<double> fronts;
    ChartSeries series{view.name};
    series.has_markers = true;
    series.has_line = false;
    // Points of one start stand beside each other.
    const double aside = 0.12 * (static_cast<double>(chart.series.size()) - 2);
    for (int member = 1; member <= members; ++member) {
      Slump slump(view, settings, member);
      slump.run_to(end);
      fronts.push_back(slump.front());
      settings.on_progress(static_cast<double>(++done) / (3 * few + 2 * many));
      if (member > few) continue;
      series.x.push_back(member + aside);
      series.y.push_back(fronts.back());
    }
    chart.series.push_back(std::move(series));
    return fronts;
  };

  const std::vector<double> fronts = fronts_of(plain, many);
  const Mean mean = mean_of(fronts), few_mean = mean_of({fronts.begin(), fronts.begin() + few});
  for (const View& view : {turned, far, reference}) {
    const Mean seen = mean_of(fronts_of(view, few));
    verdict.claims.push_back(Claim::at_most(
        fmt::format("{}: mean front of {} starts, difference in standard errors", view.name, few),
        "", std::abs(seen.value - few_mean.value) / std::hypot(seen.error, few_mean.error), 2));
  }
  const Mean stiff_mean = mean_of(fronts_of(stiff, many));
  verdict.claims.push_back(
      Claim::within_share(fmt::format("{}: mean front of {} starts", stiff.name, many), "m",
                          stiff_mean.value, mean.value, 0.02));
  verdict.charts = {std::move(chart)};
  verdict.remarks = {
      fmt::format("{} x {} particles of {:g} m; the front of {} starts is {:.3f} ± {:.3f} m, with "
                  "twice the speed of sound {:.3f} ± {:.3f} m, {:.1f} ± {:.1f} % farther",
                  cells, cells, spacing, many, mean.value, mean.error, stiff_mean.value,
                  stiff_mean.error, 100 * (stiff_mean.value / mean.value - 1),
                  100 * std::hypot(mean.error, stiff_mean.error) / mean.value)};
  if (settings.method == Method::fast)
    verdict.remarks.push_back(
        "speed of sound: a front that advances draws its outer rows apart, and the hold of density "
        "to places (docs/method.md, F9) takes pressure from them over a time that falls with the "
        "speed of sound. Of 128 starts the front is 1.793 ± 0.005 m and, with twice that speed, "
        "1.832 ± 0.006 m; without the hold, by crowding_tolerance = 0.3, 1.837 ± 0.006 and 1.845 ± "
        "0.008 m. With half the steps, or half or twice the density diffusion, it moves by less "
        "than 1 %. Under a yield stress of 3 kPa, whatever the pressure, both fronts are 1.242 m");
  return verdict;
}

}  // namespace sabo
