#pragma once

#include <cstdint>
#include <functional>
#include <future>
#include <span>
#include <vector>

#include "backend/compact.hpp"
#include "backend/device/device_backend.hpp"

// What the host sees of the particles and changes among them.

namespace sabo {

template <class Executor>
Particles& DeviceBackend<Executor>::fetched(DeviceParticles<Executor>& from, Copy& copy) {
  if (!copy.is_current) from.download(on_, copy.particles);
  copy.is_current = copy.is_lent = true;
  return copy.particles;
}

/// Whoever asks first takes the copy out of the memory where the executor leaves it.
template <class Executor>
KeptFluid DeviceBackend<Executor>::keep_fluid() {
  if (fluid_copy_.is_current) return kept_already(fluid_copy_.particles);
  if (fluid_copy_.is_kept) return kept_;
  if (kept_.valid()) kept_.wait();  // until the one before is out of there
  fluid_.start_download(on_, staged_);
  kept_then_.emplace(on_.now());
  kept_ = std::async(std::launch::deferred, [this] {
    on_.await(*kept_then_);
    return staged_.particles();
  });
  fluid_copy_.is_kept = true;
  return kept_;
}

template <class Executor>
std::span<const Vec3d> DeviceBackend<Executor>::positions() {
  if (fluid_copy_.is_current) return fluid_copy_.particles.position;
  if (!fluid_copy_.has_places) {
    on_.start_download(fluid_.position, positions_copy_);
    on_.await(on_.now());
  }
  fluid_copy_.has_places = true;
  return {positions_copy_.data(), positions_copy_.size()};
}

/// Numbers and masses stay what they are until rows change.
template <class Executor>
Places DeviceBackend<Executor>::places() {
  if (fluid_copy_.is_current) return fluid_copy_.particles;
  if (ids_copy_.empty()) {
    on_.download(fluid_.id, ids_copy_);
    on_.download(fluid_.mass, masses_copy_);
  }
  return {positions(), ids_copy_, masses_copy_};
}

template <class Executor>
void DeviceBackend<Executor>::change_boundary(const BoundaryChange& change) {
  has_list_ = false;
  if (boundary_copy_.is_lent) return change.apply_to(boundary_copy_.particles);
  Array<IdRun> runs;
  on_.upload(change.dropped, runs);
  Array<std::uint32_t> kept;
  const LiesInNone stays{boundary_.id.data(), {runs.data(), runs.size()}};
  list_kept(on_, boundary_.size(), stays, kept);
  boundary_.permute(on_, kept);
  boundary_.append(on_, change.made);
  boundary_copy_.outdate();
}

template <class Executor>
void DeviceBackend<Executor>::change_rows(const ParticleRows& rows,
                                          const std::function<void(Particles&)>& change) {
  has_list_ = false;
  if (fluid_copy_.is_lent) return sabo::change_rows(fluid_copy_.particles, rows, change);
  Array<std::uint32_t> where;
  on_.upload(rows, where);
  Particles some;
  fluid_.fetch(on_, where, some);
  change(some);
  const Particles added = take_tail(some, rows.size());
  rows_change();
  fluid_.put(on_, where, some);
  if (added.size() > 0) fluid_.append(on_, added);
}

template <class Executor>
Particles DeviceBackend<Executor>::take_out(const ParticleRows& rows) {
  has_list_ = false;
  if (fluid_copy_.is_lent) return sabo::take_out(fluid_copy_.particles, rows);
  Array<std::uint32_t> where;
  on_.upload(rows, where);
  Particles taken;
  fluid_.fetch(on_, where, taken);
  rows_change();
  Array<std::uint32_t> staying;
  list_kept(on_, fluid_.size(), IsNoneOf{where.data(), where.size()}, staying);
  fluid_.permute(on_, staying);
  return taken;
}

/// Before they do: what belongs to the rows of the list makes room.
template <class Executor>
void DeviceBackend<Executor>::rows_change() {
  forget_results();
  fluid_changed();
}

template <class Executor>
ParticleRows DeviceBackend<Executor>::driven_rows() const {
  ParticleRows rows;
  on_.download(driven_, rows);
  return rows;
}

template <class Executor>
void DeviceBackend<Executor>::change_driven(const std::function<void(Particles&)>& change) {
  using Set = DeviceParticles<Executor>;
  Particles driven;
  driven.resize(driven_.size());
  Set::fetch_rows(on_, fluid_.driven, driven_, driven.driven);
  Set::fetch_rows(on_, fluid_.position, driven_, driven.position);
  Set::fetch_rows(on_, fluid_.velocity, driven_, driven.velocity);
  change(driven);
  Set::put_rows(on_, driven.position, driven_, fluid_.position);
  Set::put_rows(on_, driven.velocity, driven_, fluid_.velocity);
  fluid_changed();
}

}  // namespace sabo
