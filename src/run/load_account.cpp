#include "run/load_account.hpp"

namespace sabo {
namespace {

Vec3d base_of(const CheckDam& dam, const Scene& scene) {
  const Vec3d middle = point_at(dam.axis, length(dam.axis) / 2);
  return {middle.x, middle.y, scene.surface->height(middle.x, middle.y)};
}

Vec3d base_of(const Body& body) {
  const Bounds bounds = bounds_of(body.mesh());
  return {0.5 * (bounds.low.x + bounds.high.x), 0.5 * (bounds.low.y + bounds.high.y), bounds.low.z};
}

}  // namespace

LoadAccount::LoadAccount(const LoadCase& settings, const Scene& scene, const FlowModel& model)
    : filter_(settings.filter) {
  const auto add = [&](const Vec3d& base) {
    accounts_.push_back(
        {base, LoadPeak(filter_), LoadProfile(base.z, model.spacing, model.kernel_radius()), {}});
  };
  for (const CheckDam& dam : scene.dams) add(base_of(dam, scene));
  for (const Body& body : scene.bodies) add(base_of(body));
}

void LoadAccount::start(double time) {
  last_taken_ = time;
  for (Account& account : accounts_) account.peak = LoadPeak(filter_, time);
}

void LoadAccount::after_step(const Stepper& stepper, const StepReport& report, Backend& backend) {
  if (accounts_.empty()) return;
  for (const BodyForce& at : backend.body_forces()) {
    if (at.force == Vec3d{}) continue;
    accounts_[at.body - 1].profile.add(at.position, report.dt * at.force);
  }
  const std::vector<BodyLoad>& impulses = stepper.body_impulses();
  for (std::size_t k = 0; k < impulses.size(); ++k)
    accounts_[k].peak.add(stepper.time(), impulses[k].force);
}

std::vector<MeanLoad> LoadAccount::take_means(const Stepper& stepper, Backend& backend) {
  for (const BodyForce& at : backend.body_forces())
    if (!at.is_foundation) accounts_[at.body - 1].profile.see(at.position, at.force != Vec3d{});
  const std::vector<BodyLoad>& impulses = stepper.body_impulses();
  const double interval = stepper.time() - last_taken_;
  last_taken_ = stepper.time();

  std::vector<MeanLoad> means;
  for (std::size_t k = 0; k < accounts_.size(); ++k) {
    Account& account = accounts_[k];
    const BodyLoad total = k < impulses.size() ? impulses[k] : BodyLoad{};
    BodyLoad mean = total;
    mean += -1.0 * account.taken;
    mean = (interval > 0 ? 1 / interval : 0.0) * mean;
    account.taken = total;
    means.push_back({mean.force, mean.moment_about(account.base), account.profile.take(interval),
                     total.force, account.peak.force(), account.peak.time()});
  }
  return means;
}

}  // namespace sabo
