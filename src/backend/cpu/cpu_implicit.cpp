#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "backend/cpu/cpu_backend.hpp"
#include "backend/cpu/parallel_blocks.hpp"
#include "backend/record_packer.hpp"
#include "backend/sweeps/shifting.hpp"

// The pair sweeps of the implicit method.

namespace sabo {
/// What the implicit sweeps keep while the same particles are awake.
void CpuBackend::prepare_rows() {
  const std::size_t fluids = fluid_.size();
  near_.reset(fluids);
  velocity_step_.reset(on_, fluids);
  viscous_.resize(fluids);
  half_gradient_.resize(fluids);
  // At the edge of the list there may be walls that no sweep packs.
  flow_.assign(fluids + boundary_.size(), {});
  motion_.assign(fluids + boundary_.size(), {});
  closing_.assign(fluids + boundary_.size(), {});
  touched_walls_.clear();
  std::vector<char> moves(fluids, 0);
  for (const std::uint32_t i : awake_) moves[i] = 1;
  for (const std::uint32_t i : driven_) moves[i] = 1;
  for (std::size_t b = fluids; b < list_.size(); ++b) {
    const PairList::Row row = list_.row(b);
    const auto is_mover = [&](std::uint32_t j) { return j < fluids && moves[j]; };
    if (std::any_of(row.fluid, row.boundary, is_mover))
      touched_walls_.push_back(static_cast<std::uint32_t>(b));
  }
  wall_pressure_.resize(touched_walls_.size());
  wall_weight_.resize(touched_walls_.size());
  chunk_rows_.assign(1, 0);
  for (std::size_t c = 0; c * PairList::chunk < fluids; ++c) {
    const auto end = std::lower_bound(awake_.begin(), awake_.end(), (c + 1) * PairList::chunk);
    chunk_rows_.push_back(static_cast<std::size_t>(end - awake_.begin()));
  }
}

/// All that the near sweeps may meet; after wall_pressure(), which knows the places.
void CpuBackend::pack_near_motion() {
  const RecordPacker pack(model_, centre_, scale_);
  const FlowView flow = view();
  const auto pack_one = [&](const ParticleView& of, std::size_t i, std::size_t at) {
    const FlowRecord& place = flow_[at];
    motion_[at] = pack.motion(of, i, {place.x, place.y, place.z});
  };
  over(fluid_.size(), threads(), [&](std::size_t i) { pack_one(flow.fluid, i, i); });
  over_rows(touched_walls_, threads(),
            [&](std::size_t at) { pack_one(flow.boundary, at - fluid_.size(), at); });
}

void CpuBackend::wall_pressure() {
  const PassClock clock(pass_times_, "wall pressure", boundary_pairs_);
  const std::size_t fluids = fluid_.size();
  const RecordPacker pack(model_, centre_, scale_);
  const FlowView flow = view();
  over(fluids, threads(), [&](std::size_t i) { flow_[i] = pack.flow(flow.fluid, i); });
  // Until their pressure is known the records of boundary particles are of use for their place.
  const auto pack_wall = [&](std::size_t at) { flow_[at] = pack.flow(flow.boundary, at - fluids); };
  over_rows(touched_walls_, threads(), pack_wall);
  const Vec3f gravity = in_single(model_.gravity);
  parallel_blocks(touched_walls_.size(), sweep_block, threads(), [&](Range range) {
    sweeps_.wall_pressure({&scale_, &list_, flow_.data(), touched_walls_.data(), range.first,
                           range.last, gravity, wall_pressure_.data(), wall_weight_.data()});
  });
  over(touched_walls_.size(), threads(), [&](std::size_t k) {
    const std::size_t b = touched_walls_[k] - fluids;
    // A wall does not pull.
    boundary_.pressure[b] = std::max(0.0, double(wall_pressure_[k]));
    boundary_.density[b] = model_.state.density(boundary_.pressure[b]);
    pack_wall(touched_walls_[k]);
  });
}

void CpuBackend::near_forces() {
  const bool needs_motion = model_.artificial_viscosity > 0 || model_.walls_move;
  if (needs_motion) pack_near_motion();
  {
    const PassClock clock(pass_times_, "force and matrix", fluid_pairs_);
    parallel_blocks(chunk_rows_.size() - 1, 1, threads(), [&](Range chunk) {
      NearPairs::Writer writer(near_, chunk.first, list_.chunk_length(chunk.first));
      sweeps_.near_force({&scale_, &list_, flow_.data(), motion_.data(), needs_motion,
                          awake_.data(), chunk_rows_[chunk.first], chunk_rows_[chunk.last],
                          model_.gravity, &writer, acceleration_.data(),
                          velocity_step_.conductance_sum.data(), velocity_step_.inverse_root.data(),
                          artificial_heat_.data(), filling_.data(), wall_share_.data()});
    });
  }
  load_bodies_by_pressure();
  add_central_force();
}

/// Of the vectors in the records, into them.
void CpuBackend::find_half_gradients() {
  parallel_blocks(awake_.size(), sweep_block, threads(), [&](Range range) {
    sweeps_.half_gradient({&scale_, &near_, awake_.data(), range.first, range.last, viscous_.data(),
                           velocity_step_.inverse_root.data(), half_gradient_.data()});
  });
  // Not by the sweep, during which others read the record.
  over_rows(awake_, threads(), [&](std::size_t i) {
    const auto& [x, y, z] = half_gradient_[i];
    const float numbers[9] = {x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z};
    std::copy(numbers, numbers + 9, viscous_[i].half_gradient);
  });
}

/// solver.product and solver.curvature of solver.direction, see VelocityStep::advance().
void CpuBackend::multiply(const float* mass, const float* drag) {
  pass_times_["viscous solve"].pairs += near_.size();
  auto& solver = velocity_step_.solver;
  const auto pack_direction = [&](std::size_t i) {
    const Quad<float>& p = solver.direction[i];
    ViscousRecord& record = viscous_[i];
    record.vx = p.x;
    record.vy = p.y;
    record.vz = p.z;
  };
  over_rows(awake_, threads(), pack_direction);
  over_rows(driven_, threads(), pack_direction);
  if (model_.whole_viscous_stress) find_half_gradients();
  dots_.assign((awake_.size() + sweep_block - 1) / sweep_block, 0);
  parallel_blocks(awake_.size(), sweep_block, threads(), [&](Range range) {
    ViscousProductTask task{
        &scale_, &near_, awake_.data(),   range.first,           range.last, viscous_.data(),
        mass,    drag,   float(step_.dt), solver.product.data(), 0};
    sweeps_.viscous_product(task);
    dots_[range.first / sweep_block] = task.dot;
  });
  solver.curvature[0] = {std::accumulate(dots_.begin(), dots_.end(), 0.0)};
}

ViscousSolve CpuBackend::advance_velocity(const VelocityTolerance& tolerance, int most_iterations) {
  const PassClock clock(pass_times_, "viscous solve");
  over(fluid_.size(), threads(),
       [&](std::size_t i) { viscous_[i] = {flow_[i].x, flow_[i].y, flow_[i].z, 0, 0, 0, {}, 0}; });
  const auto product = [&](const float* mass, const float* drag, const SolveProgress<float>*) {
    multiply(mass, drag);
  };
  return velocity_step_.advance(on_, view(), {awake_.data(), awake_.size()},
                                {driven_.data(), driven_.size()}, &step_, tolerance,
                                most_iterations, product, EnterHeat{&heat_});
}

void CpuBackend::near_motion() {
  load_bodies_by_friction();
  find_diffusion_background();
  {
    const PassClock clock(pass_times_, "wall closing", boundary_pairs_);
    pack_near_motion();
    parallel_blocks(touched_walls_.size(), sweep_block, threads(), [&](Range range) {
      sweeps_.wall_closing({&scale_, &list_, motion_.data(), touched_walls_.data(), range.first,
                            range.last, wall_pressure_.data(), wall_weight_.data(),
                            closing_.data()});
    });
  }
  const PassClock clock(pass_times_, "near motion", near_.size());
  parallel_blocks(awake_.size(), sweep_block, threads(), [&](Range range) {
    sweeps_.near_motion({&scale_, &near_, motion_.data(), background_.data(), closing_.data(),
                         wall_grip_.data(), awake_.data(), range.first, range.last, strain_.data(),
                         density_rate_.data(), diffusion_rate_.data(), support_.data()});
  });
}

void CpuBackend::fill_by_shifts(double dt) {
  const FlowView flow = view();
  over(fluid_.size(), threads(), PackShift{flow, motion_.data()});
  const FillByShifts fill{flow, dt};
  pass_times_["shifting"].pairs += near_.size();
  parallel_blocks(awake_.size(), sweep_block, threads(), [&](Range range) {
    std::array<float, sweep_block> near;
    sweeps_.shift(
        {&scale_, &near_, motion_.data(), awake_.data(), range.first, range.last, near.data()});
    for (std::size_t k = range.first; k < range.last; ++k) fill(awake_[k], near[k - range.first]);
  });
}

}  // namespace sabo
