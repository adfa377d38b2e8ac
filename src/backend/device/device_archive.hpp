#pragma once

#include "backend/backend_state.hpp"
#include "backend/device/device_backend.hpp"

namespace sabo {

template <class Executor>
template <class Archive>
void DeviceBackend<Executor>::archive_state(Archive& a) {
  std::vector<std::uint32_t> awake;
  std::vector<Vec3d> listed;
  on_.download(awake_, awake);
  on_.download(list_position_, listed);
  HeatAccount account = heat();
  BackendState state{model_.state.c0, fluid(), boundary(),   awake,
                     fetched_loads(), account, pass_times(), listed};
  state.archive(a);
  if constexpr (Archive::is_reader) {
    state.check(list_radius());
    on_.upload(std::vector{account}, account_);
    list_again(listed, awake);
  }
}

template <class Executor>
void DeviceBackend<Executor>::list_again(std::vector<Vec3d>& listed,
                                         const std::vector<std::uint32_t>& awake) {
  const BodyLoadSum loads = body_loads_;
  const PassTimes times = pass_times();
  const std::vector<double> density = boundary().density;  // of walls that find_neighbours() holds
  fluid().position.swap(listed);
  find_neighbours();
  on_.upload(listed, fluid_.position);
  fluid_changed();
  on_.upload(density, boundary_.density);
  body_loads_.restore(loads);
  if (awake.size() + driven_.size() > fluid_.size())
    throw RunError("holds more particles awake than there are");
  on_.upload(awake, awake_);
  prepare_rows();
  pass_times() = times;
}

}  // namespace sabo
