#pragma once

#include "backend/chosen_step.hpp"
#include "backend/device/pair_sweeps.hpp"
#include "backend/sweeps/flow_sums.hpp"
#include "backend/viscous_solver.hpp"
#include "physics/pair/viscous_flux.hpp"

// The two sweeps of a product with the viscous matrix, one particle at a time, in single precision.

namespace sabo {

/// Of a pair, kg/s.
SABO_HD inline float conductance(const PairGeometry<float>& pair, const FlowRecord& i,
                                 const FlowRecord& j) {
  return viscous_conductance(pair, pair_viscosity(i.viscosity, j.viscosity), i.volume, j.volume);
}

/// What the two sweeps of a product with the viscous matrix work on
/// (physics/pair/viscous_flux.hpp). The conductances are taken anew each time: to keep them would
/// double the memory of the list.
struct ViscousPairs {
  PairSums pairs;
  const FlowRecord* records;
  const Quad<float>* p;
  const SolveProgress<float>* progress;  // may be none

  SABO_HD bool is_needless() const { return progress != nullptr && progress->has_ended; }

  /// f(j, a, v, x) for a share of the fluid j near i: conductance, differences of p and of place.
  template <class F>
  SABO_HD void over(std::size_t i, RowShare share, const F& f) const {
    const FlowRecord me = records[i];
    const Quad<float> mine = p[i];
    for (std::uint32_t k = share.first; k < pairs.rows.fluid[i]; k += share.stride) {
      const std::uint32_t index = pairs.rows.at(i, k);
      const FlowRecord j = records[index];
      const Quad<float> other = p[index];
      const auto pair = pairs.geometry(me, j);
      f(index, conductance(pair, me, j),
        Vec3f{mine.x - other.x, mine.y - other.y, mine.z - other.z}, pair.x);
    }
  }
};

/// Half of the gradient of p.
struct HalfGradientSweep {
  ViscousPairs on;
  const Sym3<float>* inverse_root;
  VelocityGradient<float>* half_gradient;

  struct Sums {
    VelocityGradient<float> b;
    SABO_HD void join(const Sums& other) { b += other.b; }
  };

  SABO_HD Sums sums_of(std::size_t i, RowShare share) const {
    Sums sums;
    if (on.is_needless()) return sums;
    on.over(i, share, [&](std::uint32_t, float a, const Vec3f& v, const Vec3f& x) {
      sums.b += outer_product(v, a * x);
    });
    return sums;
  }
  SABO_HD void finish(std::size_t i, const Sums& sums) const {
    if (!on.is_needless()) half_gradient[i] = sabo::half_gradient(sums.b, inverse_root[i]);
  }
};

/// q = m p + dt (sum_j a_ij (p_i - p_j + (G_i + G_j)^T x_ij / 2) + drag p), and p.q. Without
/// gradients, where the law carries mu grad v alone, they are left out.
struct ViscousProduct {
  ViscousPairs on;
  const std::uint32_t* rows;
  const VelocityGradient<float>* half_gradient;  // may be none
  const float* mass;
  const float* drag;
  const ChosenStep* step;
  Quad<float>* q;

  struct Sums {
    Vec3f flow;
    SABO_HD void join(const Sums& other) { flow += other.flow; }
  };

  SABO_HD Sums sums_of(std::size_t place, RowShare share) const {
    Sums sums;
    if (on.is_needless()) return sums;
    const std::size_t i = rows[place];
    if (half_gradient == nullptr) {
      on.over(i, share,
              [&](std::uint32_t, float a, const Vec3f& v, const Vec3f&) { sums.flow += a * v; });
      return sums;
    }
    const VelocityGradient<float> mine = half_gradient[i];
    on.over(i, share, [&](std::uint32_t j, float a, const Vec3f& v, const Vec3f& x) {
      sums.flow += a * (v + transposed_times(mine, x) + transposed_times(half_gradient[j], x));
    });
    return sums;
  }
  SABO_HD void finish(std::size_t place, const Sums& sums, Total& sum) const {
    if (on.is_needless()) return;
    const std::size_t i = rows[place];
    const auto dt = static_cast<float>(step->dt);
    const Quad<float> mine = on.p[i];
    const Vec3f flow = Vec3f{drag[i] * mine.x, drag[i] * mine.y, drag[i] * mine.z} + sums.flow;
    const Quad<float> result{mass[i] * mine.x + dt * flow.x, mass[i] * mine.y + dt * flow.y,
                             mass[i] * mine.z + dt * flow.z};
    q[i] = result;
    sum.join({double(mine.x) * result.x + double(mine.y) * result.y + double(mine.z) * result.z});
  }
};

}  // namespace sabo
