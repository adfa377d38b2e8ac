// Compiled once for each instruction set, as pair_sweeps.cpp is.

#include "backend/cpu/simd/implicit_sweeps.hpp"
#include "backend/cpu/simd/pair_constants.hpp"

// The two sweeps of a product with the viscous matrix (physics/pair/viscous_flux.hpp).

namespace sabo {
namespace HWY_NAMESPACE {
namespace {

/// A half of the records: the first has places, velocities and two numbers of the gradients, the
/// second the other seven.
HWY_INLINE Columns half_records(const ViscousRecord* records, std::size_t half,
                                const std::uint32_t* k) {
  return load_transposed(reinterpret_cast<const float*>(records), 16, 8 * half, k);
}

/// Differences of a row from its neighbours, and the conductances.
struct Difference {
  Lanes a;
  Vec v, x;
};

template <bool periodic>
class Row {
 public:
  Row(const Constants& s, const ViscousRecord& me)
      : s_(s), place_{me.x, me.y, me.z}, velocity_{Lanes(me.vx), Lanes(me.vy), Lanes(me.vz)} {}

  Difference from(const Columns& j, const float* conductance) const {
    return {Lanes(hn::LoadU(Lanes::Tag(), conductance)), velocity_ - Vec{j[3], j[4], j[5]},
            separation<periodic>(s_, place_, j)};
  }

 private:
  const Constants& s_;
  const std::int32_t place_[3];
  const Vec velocity_;
};

HWY_INLINE Vec3f sum_of_lanes(const Vec& a) { return {sum(a.x), sum(a.y), sum(a.z)}; }

template <bool periodic>
void half_gradient_range(const HalfGradientTask& task) {
  const Constants s(*task.scale);
  for (std::size_t place = task.first; place < task.last; ++place) {
    const std::size_t i = task.rows[place];
    const NearPairs::Row row = task.near->row(i);
    const Row<periodic> me(s, task.records[i]);
    VelocityGradient<Lanes> b;
    const float* conductance = row.conductance;
    for (const std::uint32_t* k = row.fluid; k != row.boundary;
         k += Lanes::count, conductance += Lanes::count) {
      const Difference d = me.from(half_records(task.records, 0, k), conductance);
      b += outer_product(d.v, d.a * d.x);
    }
    task.half_gradient[i] = sabo::half_gradient<float>(
        {sum_of_lanes(b.x), sum_of_lanes(b.y), sum_of_lanes(b.z)}, task.inverse_root[i]);
  }
}

/// `whole`: with the transposed gradients; else what mu grad v alone carries.
template <bool periodic, bool whole>
void viscous_product_range(ViscousProductTask& task) {
  const Constants s(*task.scale);
  task.dot = 0;
  for (std::size_t place = task.first; place < task.last; ++place) {
    const std::size_t i = task.rows[place];
    const NearPairs::Row row = task.near->row(i);
    const ViscousRecord& mine = task.records[i];
    const Row<periodic> me(s, mine);
    Vec carried, weighted;
    const float* conductance = row.conductance;
    for (const std::uint32_t* k = row.fluid; k != row.boundary;
         k += Lanes::count, conductance += Lanes::count) {
      const Columns j = half_records(task.records, 0, k);
      const Difference d = me.from(j, conductance);
      Vec flux = d.v;
      if constexpr (whole) {
        const Columns g = half_records(task.records, 1, k);
        const VelocityGradient<Lanes> gradient{
            {j[6], j[7], g[0]}, {g[1], g[2], g[3]}, {g[4], g[5], g[6]}};
        flux += transposed_times(gradient, d.x);
        weighted += d.a * d.x;
      }
      carried += d.a * flux;
    }
    const Vec3f p{mine.vx, mine.vy, mine.vz};
    Vec3f flow = task.drag[i] * p + sum_of_lanes(carried);
    if constexpr (whole) {
      const float* g = mine.half_gradient;
      const VelocityGradient<float> gradient{
          {g[0], g[1], g[2]}, {g[3], g[4], g[5]}, {g[6], g[7], g[8]}};
      flow += transposed_times(gradient, sum_of_lanes(weighted));
    }
    const Vec3f q = task.mass[i] * p + task.dt * flow;
    task.q[i] = {q.x, q.y, q.z};
    task.dot += dot(in_double(p), in_double(q));
  }
}

}  // namespace

void half_gradient(const HalfGradientTask& task) {
  task.scale->periodic ? half_gradient_range<true>(task) : half_gradient_range<false>(task);
}

void viscous_product(ViscousProductTask& task) {
  if (task.scale->whole_viscous_stress)
    task.scale->periodic ? viscous_product_range<true, true>(task)
                         : viscous_product_range<false, true>(task);
  else
    task.scale->periodic ? viscous_product_range<true, false>(task)
                         : viscous_product_range<false, false>(task);
}

}  // namespace HWY_NAMESPACE
}  // namespace sabo
