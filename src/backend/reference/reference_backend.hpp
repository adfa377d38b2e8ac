#pragma once

#include "backend/host_backend.hpp"
#include "backend/velocity_step.hpp"
#include "physics/pair/geometry.hpp"

namespace sabo {

/// The oracle: serial, double precision, every particle against every other, no cleverness. All
/// other backends are tested against it.
class ReferenceBackend : public HostBackend {
 public:
  explicit ReferenceBackend(const FlowModel& model);

  /// Nothing is kept, so everything is renewed each step.
  bool neighbours_are_stale(double /*margin*/) const override { return true; }
  /// A little more than the kernel, so that there is ground ahead of the half step.
  double list_radius() const override { return 1.1 * model_.kernel_radius(); }
  void strain_and_density_rates() override;
  void momentum() override;
  void wall_pressure() override;
  void near_forces() override;
  ViscousSolve advance_velocity(const VelocityTolerance& tolerance, int most_iterations) override;
  void near_motion() override;

 protected:
  void list_pairs() override;
  void prepare_rows() override;
  void fluid_near(std::size_t i, std::vector<std::uint32_t>& near) const override;
  const std::vector<Vec3d>& listed_positions() const override { return fluid_.position; }
  void fill_by_shifts(double dt) override;

 private:
  /// What wall particle b hands back, over the sum of its weights.
  struct Closing {
    double rate = 0;  ///< 1/s
    Vec3d gradient;   ///< 1/m
  };
  Closing closing_on(std::size_t b) const;

  /// Calls f(j of all particles, geometry) for each particle within the kernel of particle i.
  template <class F>
  void for_each_neighbour(std::size_t i, bool fluid_only, const F& f) const {
    const auto kernel = model_.kernel<double>();
    const double radius = model_.kernel_radius();
    const std::size_t count = fluid_only ? fluid_.size() : fluid_.size() + boundary_.size();
    for (std::size_t j = 0; j < count; ++j) {
      if (j == i) continue;
      const Vec3d x = model_.periodic.nearest(position(i) - position(j));
      if (dot(x, x) < radius * radius) f(j, pair_geometry(x, kernel));
    }
  }

  const Vec3d& position(std::size_t k) const;
  const Vec3d& velocity(std::size_t k) const;
  double density(std::size_t k) const;
  double mass(std::size_t k) const;
  double pressure_of(std::size_t k) const;
  double pressure_term(std::size_t k) const;  ///< p / rho^2

  VelocityStep<double> velocity_step_;
};

}  // namespace sabo
