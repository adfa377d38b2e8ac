#pragma once

#include <cstddef>
#include <vector>

#include "backend/backend.hpp"
#include "backend/filling.hpp"
#include "backend/wall_share.hpp"
#include "math/sym3.hpp"
#include "physics/half_space.hpp"
#include "physics/pair/geometry.hpp"

namespace sabo {

/// A backend whose arrays live in host memory: owns the state and the sweeps that look at one
/// particle at a time. Pairs are left to the backends proper.
class HostBackend : public Backend {
 public:
  explicit HostBackend(const FlowModel& model);

  Particles& fluid() override { return fluid_; }
  Particles& boundary() override { return boundary_; }

  void find_neighbours() override;
  void pressure() override;
  void stress() override;
  void extrapolate_to_boundary() override;
  FlowExtremes extremes() const override;
  FlowHealth health() const override;
  double dissipation() const override;
  const NumericalHeat& numerical_heat() const override { return numerical_heat_; }
  void predict(double dt) override;
  void correct(double dt) override;
  void wall_resistance() override;
  void advance_state(double dt) override;
  void update_sleep() override;
  std::size_t asleep_count() const override { return asleep_count_; }
  void set_sound_speed(double c0) override;
  const std::vector<Vec3d>& accelerations() const override { return acceleration_; }
  const std::vector<double>& density_rates() const override { return density_rate_; }
  const std::vector<BodyLoad>& body_loads() const override { return body_loads_; }
  const std::vector<BodyForce>& body_forces() const override { return body_forces_; }
  void archive(ArchiveWriter& a) override { archive_state(a); }
  void archive(ArchiveReader& a) override { archive_state(a); }

 protected:
  /// Lists the pairs of the present positions, reordering the particles if it likes.
  virtual void list_pairs() = 0;
  /// Appends each fluid particle within the kernel of particle i, boundary particles counting from
  /// the last fluid one, once and without i; some that are a little farther may be among them.
  virtual void fluid_near(std::size_t i, std::vector<std::uint32_t>& near) const = 0;

  /// Where the fluid was when its pairs were listed, in its present order.
  virtual const std::vector<Vec3d>& listed_positions() const = 0;

  int threads() const { return threads_; }

  /// To be called when another set of particles is awake.
  virtual void prepare_rows() = 0;
  bool is_asleep(std::size_t i) const;
  void list_awake();
  /// To the accelerations of the particles that are awake.
  void add_central_force();
  /// Takes the rates of driven particles away: they keep their velocity and density.
  void hold_driven();
  /// Density gradients that density diffusion leaves alone.
  void find_diffusion_background();
  /// Shear rate and effective viscosity of the fluid from its strain rate and pressure.
  void find_viscosity();
  /// Pressure and effective viscosity of driven particles from their density and shear rate.
  void settle_driven();
  /// Gives the walls near driven particles their pressure.
  void hold_walls();
  void list_driven_walls();

  /// What bodies get: by the pair terms of momentum(), or by those of near_forces() and then by the
  /// wall law.
  void load_bodies_by_stress();
  void load_bodies_by_pressure();
  void load_bodies_by_friction();

  HalfSpace half_space_;
  double yield_slope_;  ///< of the model's yield: a tangent that no particle has to take again
  Particles fluid_;
  Particles boundary_;
  std::vector<std::uint32_t> awake_;   ///< fluid particles that take part in the sweeps, in order
  std::vector<std::uint32_t> driven_;  ///< fluid particles that an inflow moves, in order
  std::vector<std::uint32_t> driven_walls_;  ///< boundary particles that may be near those
  std::size_t asleep_count_ = 0;             ///< all others

  // Results of the last evaluation. Arrays over all particles hold the fluid first.
  std::vector<Sym3<double>> strain_;  ///< eps = grad v + (grad v)^T, 1/s
  std::vector<Sym3<double>> stress_;  ///< (tau - p I) / rho^2; without tau for two-point viscosity
  std::vector<double> density_rate_;  ///< kg/m3/s
  std::vector<Vec3d> acceleration_;   ///< fluid only, m/s2
  std::vector<double> pressure_power_;  ///< fluid only, v times acceleration by pressure, W/kg
  std::vector<char> has_neighbours_;    ///< fluid only

  // Of the implicit method, fluid only.
  std::vector<WallShare> wall_share_;
  std::vector<double> wall_drag_;  ///< area times resistance, kg/s
  std::vector<Vec3d> wall_slope_;  ///< normal out of the wall over the distance to it, 1/m
  std::vector<double> support_;    ///< share of the kernel that has neighbours, by its gradient
  std::vector<Vec3d> background_;  ///< density gradient that diffusion leaves alone, 1/m
  std::vector<Filling> filling_;
  std::vector<double> artificial_heat_;  ///< W/kg
  std::vector<double> diffusion_rate_;   ///< share of density diffusion in density_rate_

 private:
  void extrapolate_to(std::size_t b, const std::vector<std::uint32_t>& near);
  bool is_calm(std::size_t i) const;
  bool touches_motion(std::size_t i, std::vector<std::uint32_t>& near) const;
  void shift_particles(double dt);
  double filled_by_shifts(std::size_t i, std::vector<std::uint32_t>& near) const;
  double held_to_places(double density, std::size_t i, double catch_up) const;
  template <class Law>
  WallContact contact_of(const Law& law, std::size_t i, const Vec3d& normal, double distance) const;
  template <class Law>
  void stress_of(const Law& law, Particles& particles, std::size_t offset, bool carries_stress);
  template <class Archive>
  void archive_state(Archive& a);
  void list_again(std::vector<Vec3d>& listed);
  void list_bodies();
  void unload_bodies();
  template <class PairForce>
  void add_to_bodies(const PairForce& force);
  Vec3d artificial_on_wall(std::size_t i, std::size_t b, const PairGeometry<double>& pair) const;

  int threads_;
  NumericalHeat numerical_heat_;
  std::vector<double> heat_of_diffusion_, heat_of_hold_;  // of the step, J
  std::vector<Vec3d> shift_;                              ///< of the last step, m
  std::vector<Vec3d> start_position_;
  std::vector<Vec3d> start_velocity_;
  std::vector<double> start_density_;
  std::vector<double> start_boundary_density_;

  std::vector<BodyForce> body_forces_;  // of all boundary particles of bodies
  std::vector<Vec3d> row_forces_;       // on each of them by one kind of pairs, N
  std::vector<BodyLoad> body_loads_;
  std::vector<std::vector<std::uint32_t>> near_rows_;  // one to work with for each thread
};

}  // namespace sabo
