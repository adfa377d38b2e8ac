#include "backend/cpu/cpu_backend.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "backend/cpu/neighbour_search.hpp"
#include "backend/cpu/parallel_blocks.hpp"
#include "base/error.hpp"

namespace sabo {
namespace {

using Index = std::ptrdiff_t;

}  // namespace

CpuBackend::CpuBackend(const FlowModel& model, const PairSweeps& sweeps)
    : HostBackend(model), sweeps_(sweeps), skin_(0.3 * model.h) {
  // Otherwise two images of one particle could both be listed.
  const double shortest = 2 * (model.kernel_radius() + skin_);
  for (int axis = 0; axis < 3; ++axis)
    if (model.periodic.on(axis) && Periodic::along(model.periodic.period[axis], axis) < shortest)
      throw CaseError("periodic", "a period is shorter than two radii of the neighbour list",
                      "make it at least " + std::to_string(shortest) + " m");
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
  const int exponent = static_cast<int>(std::ceil(std::log2(reach))) - 30;
  scale_.unit = static_cast<float>(std::ldexp(1.0, exponent));

  scale_.periodic = model_.periodic.any();
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3d& p = model_.periodic.period[axis];
    scale_.period[axis] = {float(p.x), float(p.y), float(p.z)};
    scale_.inverse_period[axis] =
        model_.periodic.on(axis) ? float(1 / Periodic::along(p, axis)) : 0.0f;
  }
  const Vec3d origin = model_.central.origin - centre_;
  scale_.central = float(model_.central.strength);
  scale_.central_origin = {float(origin.x), float(origin.y), float(origin.z)};
  const auto kernel = model_.kernel<float>();
  scale_.h = kernel.h;
  scale_.kernel_alpha = kernel.alpha;
  scale_.eta2 = float(model_.eta2());
  scale_.rho0 = float(model_.state.rho0);
  set_sound_terms();
  scale_.wall_velocity_factor = float(model_.wall_velocity_factor());
  scale_.dimension = model_.dimension;
  scale_.two_point_viscosity = model_.viscous_operator == ViscousOperator::morris;
}

/// What depends on the sound speed, which may change from step to step.
void CpuBackend::set_sound_terms() {
  const double c0 = model_.state.c0;
  const Vec3d background = model_.diffusion_background(model_.central.origin);
  scale_.two_zeta_h_c0 = float(2 * model_.density_diffusion * model_.h * c0);
  scale_.hydrostatic = {float(background.x), float(background.y), float(background.z)};
  if (model_.diffusion_form == DiffusionForm::fourtakas)
    scale_.hydrostatic_slope = float(model_.central.strength / (c0 * c0));
  scale_.alpha_c0_h = float(model_.artificial_viscosity * c0 * model_.h);
}

void CpuBackend::set_sound_speed(double c0) {
  HostBackend::set_sound_speed(c0);
  set_sound_terms();
}

bool CpuBackend::neighbours_are_stale(double margin) const {
  const PassClock clock(pass_times_, "checks and sums");
  if (list_.size() != fluid_.size() + boundary_.size()) return true;
  return age_.is_stale(fluid_.position, skin_, margin);
}

void CpuBackend::pack_motion() {
  const PassClock clock(pass_times_, "records");
  motion_.resize(fluid_.size() + boundary_.size());
  const double per_unit = 1.0 / scale_.unit;
  std::size_t offset = 0;
  for (const Particles* p : {&fluid_, &boundary_}) {
    const Index count = static_cast<Index>(p->size());
#pragma omp parallel for num_threads(threads()) if (count > worth_threads) schedule(static)
    for (Index i = 0; i < count; ++i) {
      const Vec3d x = per_unit * (p->position[i] - centre_);
      const Vec3d& v = p->velocity[i];
      motion_[offset + i] = {static_cast<std::int32_t>(std::lrint(x.x)),
                             static_cast<std::int32_t>(std::lrint(x.y)),
                             static_cast<std::int32_t>(std::lrint(x.z)),
                             float(v.x),
                             float(v.y),
                             float(v.z),
                             float(p->density[i] / model_.state.rho0 - 1),
                             float(p->mass[i] / p->density[i])};
    }
    offset += p->size();
  }
}

void CpuBackend::pack_stress() {
  const PassClock clock(pass_times_, "records");
  stress_records_.resize(motion_.size());
  const double convention = model_.strain_convention();
  std::size_t offset = 0;
  for (const Particles* p : {&fluid_, &boundary_}) {
    const Index count = static_cast<Index>(p->size());
#pragma omp parallel for num_threads(threads()) if (count > worth_threads) schedule(static)
    for (Index i = 0; i < count; ++i) {
      const MotionRecord& m = motion_[offset + i];
      const Sym3<double>& s = stress_[offset + i];
      stress_records_[offset + i] = {m.x,
                                     m.y,
                                     m.z,
                                     float(p->mass[i]),
                                     float(s.xx),
                                     float(s.xy),
                                     float(s.xz),
                                     float(s.yy),
                                     float(s.yz),
                                     float(s.zz),
                                     m.vx,
                                     m.vy,
                                     m.vz,
                                     float(convention * p->viscosity[i]),
                                     float(p->density[i]),
                                     float(p->pressure[i] / (p->density[i] * p->density[i]))};
    }
    offset += p->size();
  }
}

void CpuBackend::strain_and_density_rates() {
  pack_motion();
  const PassClock clock(pass_times_, "motion sweep", fluid_pairs_ + boundary_pairs_);
  parallel_blocks(motion_.size(), sweep_block, threads(), [&](Range range) {
    sweeps_.motion({&scale_, &list_, motion_.data(), fluid_.size(), range.first, range.last,
                    strain_.data(), density_rate_.data()});
  });
}

void CpuBackend::momentum() {
  pack_stress();
  {
    const PassClock clock(pass_times_, "force sweep", fluid_pairs_);
    parallel_blocks(fluid_.size(), sweep_block, threads(), [&](Range range) {
      sweeps_.force({&scale_, &list_, stress_records_.data(), range.first, range.last,
                     model_.gravity, acceleration_.data(), pressure_power_.data()});
    });
  }
  load_bodies_by_stress();
  add_central_force();
  hold_driven();
}

}  // namespace sabo
