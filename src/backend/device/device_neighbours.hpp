#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>
#include <utility>

#include "backend/check_periods.hpp"
#include "backend/compact.hpp"
#include "backend/device/column_search.hpp"
#include "backend/device/device_copies.hpp"
#include "backend/device/implicit_pair_sweeps.hpp"
#include "backend/device/list_motion.hpp"
#include "backend/sweeps/boundary_sweeps.hpp"
#include "backend/sweeps/driven.hpp"
#include "backend/sweeps/explicit_sweeps.hpp"
#include "backend/sweeps/sleep.hpp"
#include "base/error.hpp"

// Sorting, neighbours, and the arrays that go with them.

namespace sabo {

inline constexpr std::size_t few_columns = 1'000'000;
inline constexpr std::size_t most_columns = std::size_t{1} << 31;  // of keys with 32 bits below

template <class Executor>
DeviceBackend<Executor>::DeviceBackend(const FlowModel& model, const Executor& on)
    : Backend(model), on_(on), skin_(0.2 * model.h), yield_slope_(model.yield.slope()) {
  check_periods(model, list_radius());
  on_.upload(std::vector<HalfSpace>{HalfSpace(model.h, model.dimension, model.spacing)},
             half_space_);
  on_.zero(account_, 1);
  on_.zero(step_, 1);
  velocity_step_.solver.runs_ahead = true;
}

template <class Executor>
FlowView DeviceBackend<Executor>::view() {
  FlowView flow;
  flow.model = model_;
  flow.yield_slope = yield_slope_;
  flow.half_space = half_space_.data();
  flow.fluid_count = fluid_.size();
  flow.fluid = fluid_.view();
  flow.boundary = boundary_.view();
  FlowArrays::point(flow, *this);
  return flow;
}

template <class Executor>
PairRows DeviceBackend<Executor>::rows() const {
  return {slice_starts_.data(), entries_.data(), fluid_neighbours_.data(), neighbours_.data()};
}

template <class Executor>
void DeviceBackend<Executor>::find_neighbours() {
  if (fluid_copy_.is_lent) fluid_.upload(on_, fluid_copy_.particles);
  if (boundary_copy_.is_lent) boundary_.upload(on_, boundary_copy_.particles);
  fluid_changed();
  boundary_copy_.outdate();
  has_list_ = false;  // until there is one again: memory may run out
  forget_results();
  if (model_.periodic.any())
    on_.for_each(fluid_.size(), WrapPosition{model_.periodic, fluid_.position.data()});
  const CloudBox fluid_box = box_of(fluid_), boundary_box = box_of(boundary_);
  set_scale(fluid_box, boundary_box);
  {
    const Clock clock(*this, "sort");
    sorted_fluid_ = sort(fluid_, fluid_box);
    sorted_boundary_ = sort(boundary_, boundary_box);
  }
  {
    const Clock clock(*this, "neighbour search");
    list_pairs();
    pass_times_["neighbour search"].pairs += pairs_.all();
  }
  sorted_boundary_ = {};
  on_.release(sorted_fluid_.places);
  on_.copy(fluid_.position, list_position_);
  list_bodies();
  on_.zero(density_rate_, all());
  on_.zero(acceleration_, fluid_.size());
  list_awake();
  list_driven();
  prepare_rows();
  has_list_ = true;
}

template <class Executor>
void DeviceBackend<Executor>::list_bodies() {
  list_kept(on_, boundary_.size(), BelongsToBody{boundary_.view()}, body_rows_);
  Array<BodyForce> listed;
  on_.zero(listed, body_rows_.size());
  on_.for_each(listed.size(), FindBodyParticle{boundary_.view(), body_rows_.data(), listed.data()});
  std::vector<BodyForce> particles;
  on_.download(listed, particles);
  fetched_loads().list(std::move(particles), ground_level_);
  on_.zero(row_forces_, body_rows_.size());
}

/// The order of the particles is another one now.
template <class Executor>
void DeviceBackend<Executor>::forget_results() {
  ids_copy_.clear();
  for (auto* array : {&strain_, &stress_}) on_.release(*array);
  on_.release(wall_grip_);
  on_.release(background_);
  on_.release(shift_);
  for (auto* array :
       {&wall_drag_, &support_, &artificial_heat_, &diffusion_rate_, &wall_heat_, &pressure_power_})
    on_.release(*array);
  on_.release(wall_share_);
  on_.release(filling_);
  on_.release(entries_);
  on_.release(flow_records_);
  on_.release(motion_);
  on_.release(closings_);
}

template <class Executor>
void DeviceBackend<Executor>::need_explicit_arrays() {
  const bool have_all = strain_.size() == all() && stress_.size() == all();
  if (have_all && pressure_power_.size() == fluid_.size()) return;
  on_.zero(strain_, all());
  on_.zero(stress_, all());
  // The last is one that is looked at: memory may run out before.
  for (auto* array : {&diffusion_rate_, &wall_heat_, &pressure_power_})
    on_.zero(*array, fluid_.size());
}

template <class Executor>
void DeviceBackend<Executor>::need_implicit_arrays() {
  const std::size_t fluids = fluid_.size();
  if (wall_drag_.size() == fluids) return;
  on_.zero(strain_, fluids);
  on_.zero(wall_share_, fluids);
  on_.zero(filling_, fluids);
  on_.zero(wall_grip_, fluids);
  if (model_.artificial_viscosity > 0) on_.zero(artificial_heat_, fluids);
  if (model_.diffusion_form == DiffusionForm::fourtakas) on_.zero(background_, fluids);
  // The last is the one that is looked at: memory may run out before.
  for (auto* array : {&support_, &diffusion_rate_, &wall_drag_}) on_.zero(*array, fluids);
}

template <class Executor>
CloudBox DeviceBackend<Executor>::box_of(const DeviceParticles<Executor>& set) const {
  return on_.template reduce<CloudBox>(set.size(), FindBox{set.position.data()});
}

template <class Executor>
void DeviceBackend<Executor>::set_scale(CloudBox box, const CloudBox& boundary_box) {
  box.join(boundary_box);
  if (box.is_empty()) box = {{}, {}};
  const Vec3d size = box.high - box.low;
  centre_ = 0.5 * (box.low + box.high);
  // The list is made anew long before a particle leaves the doubled box.
  scale_ = PairScale(model_, centre_, size.x + size.y + size.z + list_radius());
}

template <class Executor>
typename DeviceBackend<Executor>::SortedSet DeviceBackend<Executor>::sort(
    DeviceParticles<Executor>& set, const CloudBox& box) {
  SortedSet sorted;
  const std::size_t count = set.size();
  sorted.lattice = ColumnLattice(box, list_radius());
  Array<std::uint64_t> keys;
  Array<std::uint32_t> order;
  on_.reserve(keys, count);
  on_.reserve(order, count);
  on_.for_each(count,
               MakeKey{sorted.lattice, packer(), set.position.data(), keys.data(), order.data()});
  const auto columns = sorted.lattice.columns();
  if (columns > most_columns)
    throw RunError("the flow has spread too far for a card: its box holds " +
                   std::to_string(columns) + " columns as wide as a kernel; --backend cpu runs it");
  on_.sort(keys, order, 32 + static_cast<int>(std::bit_width(columns)));
  on_.reserve(sorted.first, columns + 1);
  on_.for_each(columns + 1, FindColumn{keys.data(), count, sorted.first.data()});
  on_.release(keys);
  set.permute(on_, order);
  on_.reserve(sorted.places, count);
  on_.for_each(count, MakePlace{packer(), set.position.data(), sorted.places.data()});
  return sorted;
}

template <class Executor>
void DeviceBackend<Executor>::list_pairs() {
  const std::size_t fluids = fluid_.size();
  const auto columns = [](const SortedSet& set, std::size_t offset) {
    return ColumnSet{set.lattice, set.first.data(), set.places.data(),
                     static_cast<std::uint32_t>(offset)};
  };
  const PairSearch search{columns(sorted_fluid_, 0),
                          columns(sorted_boundary_, fluids),
                          fluids,
                          fluid_.position.data(),
                          boundary_.position.data(),
                          packer(),
                          scale_.unit,
                          list_radius(),
                          Images(model_.periodic)};
  on_.reserve(fluid_neighbours_, all());
  on_.reserve(neighbours_, all());
  on_.reserve(has_neighbours_, fluids);
  on_.for_each(all(), CountPairs{search, fluid_neighbours_.data(), neighbours_.data(),
                                 has_neighbours_.data()});
  const std::size_t slices = (all() + PairRows::slice - 1) / PairRows::slice;
  on_.reserve(slice_starts_, slices + 1);
  on_.for_each(slices + 1, MeasureSlice{neighbours_.data(), all(), slice_starts_.data()});
  on_.scan(slice_starts_);
  on_.reserve(entries_, on_.last(slice_starts_));
  on_.for_each(all(), WritePairs{search, slice_starts_.data(), entries_.data()});
  pairs_ = on_.template reduce<PairCount>(all(), SumPairs{neighbours_.data(), fluids});
}

template <class Executor>
bool DeviceBackend<Executor>::neighbours_are_stale(double margin) const {
  const bool has_changed =
      fluid_copy_.is_lent && fluid_copy_.particles.size() != list_position_.size();
  if (!has_list_ || has_changed || list_position_.size() != fluid_.size()) return true;
  const double moved = std::sqrt(state_sums().way.square);
  if (!(moved + margin <= skin_)) return true;
  return 2 * (moved + margin) > skin_ && !(relative_way() + 2 * margin <= skin_);
}

/// The most that two particles which could have met have moved against each other, m.
template <class Executor>
double DeviceBackend<Executor>::relative_way() const {
  const Clock clock(*this, "checks and sums");
  const FindWay way{fluid_.position.data(), list_position_.data()};
  // Across a border of the box columns far from each other are neighbours; and in a wide box with
  // little in it columns would take more than the particles.
  const bool is_sparse = sorted_fluid_.lattice.columns() > std::max(few_columns, 4 * fluid_.size());
  if (model_.periodic.any() || is_sparse) {
    const auto box = on_.template reduce<CloudBox>(fluid_.size(), way);
    return norm(box.high - box.low);
  }
  const ColumnLattice& lattice = sorted_fluid_.lattice;
  Array<CloudBox> ways;
  on_.reserve(ways, lattice.columns());
  on_.for_each(ways.size(), FindColumnWays{way, sorted_fluid_.first.data(), ways.data()});
  const FindLongestRelativeWay longest{lattice, ways.data()};
  return std::sqrt(on_.template reduce<Longest>(ways.size(), longest).square);
}

template <class Executor>
void DeviceBackend<Executor>::list_awake() {
  list_kept(on_, fluid_.size(), IsAwake{model_, fluid_.calm.data(), fluid_.driven.data()}, awake_);
}

/// Driven particles, with their state, and the walls near them.
template <class Executor>
void DeviceBackend<Executor>::list_driven() {
  list_kept(on_, fluid_.size(), IsDriven{fluid_.driven.data()}, driven_);
  on_.reserve(driven_walls_, 0);
  if (driven_.size() == 0) return;
  std::visit(
      [&](const auto& law) {
        over_driven(SettleDriven<std::decay_t<decltype(law)>>{view(), law});
      },
      model_.rheology);
  const MayTouchDriven<RowNear> may_touch{view(), RowNear{rows()}};
  list_kept(on_, boundary_.size(), may_touch, driven_walls_);
  hold_walls();
}

/// What the implicit sweeps keep while the same particles are awake.
template <class Executor>
void DeviceBackend<Executor>::prepare_rows() {
  velocity_step_.reset(on_, 0);
  Array<char> moves;
  on_.zero(moves, fluid_.size());
  over_awake(MarkMoving{moves.data()});
  over_driven(MarkMoving{moves.data()});
  list_kept(on_, boundary_.size(), IsTouched{fluid_.size(), rows(), moves.data()}, touched_);
  swept_ = pairs_;
  if (awake_.size() == fluid_.size()) return;
  const auto pairs_at = [&](const Array<std::uint32_t>& of, std::size_t offset) {
    return on_.template reduce<Total>(of.size(),
                                      SumPairsAt{of.data(), neighbours_.data() + offset});
  };
  swept_.fluid = static_cast<std::uint64_t>(pairs_at(awake_, 0).value);
  swept_.boundary = static_cast<std::uint64_t>(pairs_at(touched_, fluid_.size()).value);
}

}  // namespace sabo
