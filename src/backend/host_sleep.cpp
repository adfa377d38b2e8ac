#include "backend/host_backend.hpp"

// Which particles take part in the sweeps of the implicit method.

namespace sabo {

bool HostBackend::is_asleep(std::size_t i) const {
  return model_.sleep.speed > 0 && fluid_.calm[i] >= model_.sleep.time;
}

/// Slow, below yield and among others.
bool HostBackend::is_calm(std::size_t i) const {
  const SleepRule& rule = model_.sleep;
  if (!(rule.speed > 0) || !has_neighbours_[i]) return false;
  if (dot(fluid_.velocity[i], fluid_.velocity[i]) > rule.speed * rule.speed) return false;
  const double yield = model_.yield(fluid_.pressure[i], yield_slope_);
  return fluid_.viscosity[i] * fluid_.shear_rate[i] < SleepRule::yield_share * yield;
}

void HostBackend::list_awake() {
  awake_.clear();
  driven_.clear();
  for (std::size_t i = 0; i < fluid_.size(); ++i) {
    if (fluid_.driven[i] != 0)
      driven_.push_back(static_cast<std::uint32_t>(i));
    else if (!is_asleep(i))
      awake_.push_back(static_cast<std::uint32_t>(i));
  }
  asleep_count_ = fluid_.size() - awake_.size() - driven_.size();
}

bool HostBackend::touches_motion(std::size_t i, std::vector<std::uint32_t>& near) const {
  const double speed = SleepRule::waking * model_.sleep.speed;
  near.clear();
  fluid_near(i, near);
  for (const std::uint32_t j : near)
    if (dot(fluid_.velocity[j], fluid_.velocity[j]) > speed * speed) return true;
  return false;
}

void HostBackend::update_sleep() {
  if (!(model_.sleep.speed > 0)) return;
  const PassClock clock(pass_times_, "sleep");
  const auto count = static_cast<std::ptrdiff_t>(fluid_.size());
  std::vector<char> wakes(fluid_.size(), 0);
#pragma omp parallel num_threads(threads_)
  {
    std::vector<std::uint32_t> near;
#pragma omp for schedule(static)
    for (std::ptrdiff_t i = 0; i < count; ++i)
      if (is_asleep(static_cast<std::size_t>(i)))
        wakes[i] = touches_motion(static_cast<std::size_t>(i), near);
  }
  const std::size_t before = awake_.size();
  bool changes = false;
  for (std::size_t i = 0; i < fluid_.size(); ++i) {
    if (wakes[i]) fluid_.calm[i] = 0;
    changes = changes || wakes[i];
    if (!is_asleep(i)) continue;
    fluid_.velocity[i] = {};
    fluid_.drag[i] = {};
  }
  list_awake();
  if (changes || awake_.size() != before) prepare_rows();
}

}  // namespace sabo
