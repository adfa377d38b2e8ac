#include <algorithm>

#include "backend/host_backend.hpp"
#include "backend/host_loops.hpp"
#include "physics/pair/strain_rate.hpp"

// Particle shifting of the implicit method: inside of a flow that strains for long, particles
// gather in filaments and leave others bare. So they are moved down the gradient of the filling of
// their kernel (Fick's law; Lind, Xu, Stansby & Rogers 2012), with the diffusivity over a step
//   D = h^2 min(1/2, a |shear rate| dt).
// One half is the limit of stability, which Lind et al. take in every step. With the strain of the
// step places even out as fast as the flow disturbs them, whatever the length of the step, and a
// deposit is left alone. Mass and momentum stay with the particles.

namespace sabo {
namespace {

constexpr double most_diffusivity = 0.5;  // over a step, of h^2
constexpr double most_shift = 0.1;        // of the spacing
// Filled share of the kernel from which on a particle begins to count as inside. Near a free
// surface the gradient of the filling shows the way out.
constexpr double inside_from = 0.95;

}  // namespace

/// Before the flow moves them: all sums of the step are of the places that particles have now.
void HostBackend::shift_particles(double dt) {
  const PassClock clock(pass_times_, "shifting");
  const double h = model_.h;
  shift_.assign(fluid_.size(), {});
  if (!(dt > 0)) return;
  over_rows(awake_, threads_, [&](std::size_t i) {
    const double inside = std::clamp((support_[i] - inside_from) / (1 - inside_from), 0.0, 1.0);
    const double strain = shear_rate(strain_[i]) * dt;
    const double diffusivity =
        inside * h * h * std::min(most_diffusivity, model_.particle_shifting * strain);
    const Vec3d shift = -diffusivity * filling_[i].gradient;
    const double most = most_shift * model_.spacing;
    const double size = norm(shift);
    shift_[i] = size > most ? (most / size) * shift : shift;
  });
  const double per_step = model_.state.rho0 / dt;
#pragma omp parallel num_threads(threads_)
  {
    std::vector<std::uint32_t> near;
#pragma omp for schedule(static)
    for (std::ptrdiff_t k = 0; k < static_cast<std::ptrdiff_t>(awake_.size()); ++k) {
      const std::size_t i = awake_[k];
      density_rate_[i] += per_step * filled_by_shifts(i, near);
    }
  }
  over_rows(awake_, threads_, [&](std::size_t i) { fluid_.position[i] += shift_[i]; });
}

/// What the shifts of a particle and of its neighbours change in the filling of its kernel:
/// sum of V_j (s_i - s_j) . grad W. Continuity sees the flow alone, whose disorder fills kernels on
/// average; without what shifting takes back from them density would creep up.
double HostBackend::filled_by_shifts(std::size_t i, std::vector<std::uint32_t>& near) const {
  const auto kernel = model_.kernel<double>();
  near.clear();
  fluid_near(i, near);
  double filled = dot(shift_[i], filling_[i].gradient);
  for (const std::uint32_t j : near) {
    const Vec3d x = model_.periodic.nearest(fluid_.position[i] - fluid_.position[j]);
    const double volume = fluid_.mass[j] / model_.state.rho0;
    filled -= volume * kernel.gradient_factor(norm(x)) * dot(shift_[j], x);
  }
  return filled;
}

}  // namespace sabo
