#pragma once

#include <cstddef>
#include <vector>

#include "backend/backend.hpp"
#include "backend/body_load_sum.hpp"
#include "backend/flow_view.hpp"
#include "backend/host_executor.hpp"
#include "backend/sweeps/flow_sums.hpp"

namespace sabo {

/// A backend whose arrays live in host memory: owns the state and the sweeps that look at one
/// particle at a time. Pairs are left to the backends proper.
class HostBackend : public Backend {
 public:
  explicit HostBackend(const FlowModel& model);

  Particles& fluid() override { return fluid_; }
  KeptFluid keep_fluid() override { return kept_already(fluid_); }
  std::span<const Vec3d> positions() override { return fluid_.position; }
  Places places() override { return fluid_; }
  Particles& boundary() override { return boundary_; }
  void change_boundary(const BoundaryChange& change) override { change.apply_to(boundary_); }
  void change_rows(const ParticleRows& rows,
                   const std::function<void(Particles&)>& change) override {
    sabo::change_rows(fluid_, rows, change);
  }
  Particles take_out(const ParticleRows& rows) override { return sabo::take_out(fluid_, rows); }
  ParticleRows driven_rows() const override { return driven_; }
  void change_driven(const std::function<void(Particles&)>& change) override { change(fluid_); }
  std::size_t fluid_count() const override { return fluid_.size(); }
  std::size_t boundary_count() const override { return boundary_.size(); }

  void find_neighbours() override;
  void pressure() override;
  void stress() override;
  void extrapolate_to_boundary() override;
  void choose_step(const StepRule& rule, double longest) override;
  ChosenStep chosen_step() const override { return step_; }
  double fastest() const override;
  FlowHealth health() const override;
  const HeatAccount& heat() const override { return heat_; }
  void predict() override;
  void correct() override;
  void wall_resistance() override;
  void advance_state() override;
  void update_sleep() override;
  std::size_t asleep_count() const override { return asleep_count_; }
  void set_sound_speed(double c0) override;
  const std::vector<Vec3d>& accelerations() const override { return acceleration_; }
  const std::vector<double>& density_rates() const override { return density_rate_; }
  const std::vector<BodyLoad>& body_loads() const override { return body_loads_.loads(); }
  const std::vector<BodyForce>& body_forces() const override { return body_loads_.forces(); }
  void archive(ArchiveWriter& a) override { archive_state(a); }
  void archive(ArchiveReader& a) override { archive_state(a); }

 protected:
  friend class HostNear;
  friend struct FlowArrays;

  /// Lists the pairs of the present positions, reordering the particles if it likes.
  virtual void list_pairs() = 0;
  /// Appends each fluid particle within the kernel of particle i, boundary particles counting from
  /// the last fluid one, once and without i; some that are a little farther may be among them.
  virtual void fluid_near(std::size_t i, std::vector<std::uint32_t>& near) const = 0;
  /// Where the fluid was when its pairs were listed, in its present order.
  virtual const std::vector<Vec3d>& listed_positions() const = 0;

  int threads() const { return on_.threads(); }
  /// The arrays as they are now.
  FlowView view();

  /// Adds FillByShifts to the density rates; after near_motion(), before anything has moved.
  virtual void fill_by_shifts(double dt) = 0;

  /// To be called when another set of particles is awake.
  virtual void prepare_rows() = 0;
  bool is_asleep(std::size_t i) const;
  void list_awake();
  /// To the accelerations of the particles that are awake.
  void add_central_force();
  /// Driven particles keep their velocity and density, the walls near them have their pressure.
  void hold_driven();
  /// Density gradients that density diffusion leaves alone.
  void find_diffusion_background();
  /// Shear rate and effective viscosity of the fluid from its strain rate and pressure.
  void find_viscosity();

  /// What bodies get: by the pair terms of momentum(), or by those of near_forces() and then by the
  /// wall law.
  void load_bodies_by_stress();
  void load_bodies_by_pressure();
  void load_bodies_by_friction();

  HalfSpace half_space_;
  double yield_slope_;
  HostExecutor on_;
  Particles fluid_;
  Particles boundary_;
  std::vector<std::uint32_t> awake_;   ///< fluid particles that take part in the sweeps, in order
  std::vector<std::uint32_t> driven_;  ///< fluid particles that an inflow moves, in order
  std::size_t asleep_count_ = 0;       ///< all others
  HeatAccount heat_;
  ChosenStep step_;

  // Results of the last evaluation. Arrays over all particles hold the fluid first.
  std::vector<Sym3<double>> strain_;  ///< eps = grad v + (grad v)^T, 1/s
  std::vector<Sym3<double>> stress_;  ///< (tau - p I) / rho^2; without tau for two-point viscosity
  std::vector<double> density_rate_;  ///< kg/m3/s
  std::vector<Vec3d> acceleration_;   ///< fluid only, as all below; m/s2
  std::vector<double> pressure_power_;  ///< v times acceleration by pressure, W/kg
  std::vector<double> wall_heat_;       ///< what pressure between flow and walls loses, W/kg
  std::vector<double> diffusion_rate_;  ///< share of density diffusion in density_rate_
  std::vector<char> has_neighbours_;

  // Of the implicit method, fluid only.
  std::vector<WallShare> wall_share_;
  std::vector<double> wall_drag_;  ///< area times resistance, kg/s
  std::vector<WallGrip> wall_grip_;
  std::vector<double> support_;    ///< share of the kernel that has neighbours, by its gradient
  std::vector<Vec3d> background_;  ///< density gradient that diffusion leaves alone, 1/m
  std::vector<Filling> filling_;
  std::vector<double> artificial_heat_;  ///< W/kg
  std::vector<Shift> shift_;             ///< of the last step

 private:
  Fastest find_fastest() const;
  void settle_driven();
  void hold_walls();
  void shift_particles(double dt);
  template <class PairForce>
  void add_to_bodies(const PairForce& force);
  template <class Archive>
  void archive_state(Archive& a);
  void list_again(std::vector<Vec3d>& listed);
  void list_bodies();

  std::vector<std::uint32_t> driven_walls_;  // boundary particles that may be near driven ones
  std::vector<Vec3d> start_position_;
  std::vector<Vec3d> start_velocity_;
  std::vector<double> start_density_;
  std::vector<double> start_boundary_density_;

  BodyLoadSum body_loads_;
  std::vector<std::uint32_t> body_rows_;  // boundary particles of bodies
  std::vector<Vec3d> row_forces_;         // on each of them, N
};

}  // namespace sabo
