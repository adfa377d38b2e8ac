#include "backend/cpu/cpu_backend.hpp"

#include <algorithm>
#include <iterator>

#include "backend/check_periods.hpp"
#include "backend/cpu/neighbour_search.hpp"
#include "backend/cpu/parallel_blocks.hpp"
#include "backend/record_packer.hpp"

namespace sabo {

CpuBackend::CpuBackend(const FlowModel& model, const PairSweeps& sweeps)
    : HostBackend(model), sweeps_(sweeps), skin_(0.3 * model.h) {
  check_periods(model, list_radius());
}

void CpuBackend::list_pairs() {
  NeighbourSearch search(model_.periodic, list_radius(), threads(), sweeps_);
  {
    const PassClock clock(pass_times_, "sort");
    search.sort(fluid_, boundary_);
  }
  {
    const PassClock clock(pass_times_, "neighbour search");
    search.fill(fluid_.position, boundary_.position, list_, has_neighbours_);
    fluid_pairs_ = list_.pairs(0, fluid_.size());
    boundary_pairs_ = list_.pairs(fluid_.size(), list_.size());
    pass_times_["neighbour search"].pairs += fluid_pairs_ + boundary_pairs_;
  }
  age_.start(fluid_.position, list_radius(), model_.periodic.any());
  set_scale();
  list_awake();
  prepare_rows();
}

void CpuBackend::fluid_near(std::size_t self, std::vector<std::uint32_t>& near) const {
  const PairList::Row row = list_.row(self);
  std::copy_if(row.fluid, row.boundary, std::back_inserter(near),
               [&](std::uint32_t j) { return j != self; });
}

void CpuBackend::set_scale() {
  Vec3d low, high;
  bounding_box({&fluid_.position, &boundary_.position}, low, high);
  centre_ = 0.5 * (low + high);
  // The list is made anew long before a particle leaves the doubled box.
  const double reach = (high.x - low.x) + (high.y - low.y) + (high.z - low.z) + list_radius();
  scale_ = PairScale(model_, centre_, reach);
}

void CpuBackend::set_sound_speed(double c0) {
  HostBackend::set_sound_speed(c0);
  scale_.set_sound_speed(model_);
}

bool CpuBackend::neighbours_are_stale(double margin) const {
  const PassClock clock(pass_times_, "checks and sums");
  if (list_.size() != fluid_.size() + boundary_.size()) return true;
  return age_.is_stale(fluid_.position, skin_, margin);
}

void CpuBackend::pack_motion() {
  const PassClock clock(pass_times_, "records");
  motion_.resize(fluid_.size() + boundary_.size());
  const RecordPacker pack(model_, centre_, scale_);
  std::size_t offset = 0;
  for (Particles* p : {&fluid_, &boundary_}) {
    const ParticleView of = view_of(*p);
    over(p->size(), threads(), [&](std::size_t i) {
      motion_[offset + i] = pack.motion(of, i, pack.place(of.position[i]));
    });
    offset += p->size();
  }
}

void CpuBackend::pack_stress() {
  const PassClock clock(pass_times_, "records");
  stress_records_.resize(motion_.size());
  const RecordPacker pack(model_, centre_, scale_);
  std::size_t offset = 0;
  for (Particles* p : {&fluid_, &boundary_}) {
    const ParticleView of = view_of(*p);
    over(p->size(), threads(), [&](std::size_t i) {
      stress_records_[offset + i] = pack.stress(of, i, stress_[offset + i], motion_[offset + i]);
    });
    offset += p->size();
  }
}

void CpuBackend::strain_and_density_rates() {
  pack_motion();
  const PassClock clock(pass_times_, "motion sweep", fluid_pairs_ + boundary_pairs_);
  parallel_blocks(motion_.size(), sweep_block, threads(), [&](Range range) {
    sweeps_.motion({&scale_, &list_, motion_.data(), fluid_.size(), range.first, range.last,
                    strain_.data(), density_rate_.data(), diffusion_rate_.data()});
  });
}

void CpuBackend::momentum() {
  pack_stress();
  {
    const PassClock clock(pass_times_, "force sweep", fluid_pairs_);
    parallel_blocks(fluid_.size(), sweep_block, threads(), [&](Range range) {
      sweeps_.force({&scale_, &list_, stress_records_.data(), range.first, range.last,
                     model_.gravity, acceleration_.data(), pressure_power_.data(),
                     wall_heat_.data()});
    });
  }
  load_bodies_by_stress();
  add_central_force();
  hold_driven();
}

}  // namespace sabo
