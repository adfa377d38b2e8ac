#pragma once

#include <array>
#include <vector>

#include "backend/cpu/list_age.hpp"
#include "backend/cpu/pair_list.hpp"
#include "backend/cpu/pair_sweeps.hpp"
#include "backend/host_backend.hpp"
#include "backend/records.hpp"
#include "backend/velocity_step.hpp"

namespace sabo {

/// OpenMP threads, particles sorted by column, a neighbour list with skin, pair sums in single
/// precision over exact position differences. State and integration stay in double precision.
class CpuBackend : public HostBackend {
 public:
  explicit CpuBackend(const FlowModel& model, const PairSweeps& sweeps = best_pair_sweeps());

  bool neighbours_are_stale(double margin) const override;
  double list_radius() const override { return model_.kernel_radius() + skin_; }
  void strain_and_density_rates() override;
  void momentum() override;
  void wall_pressure() override;
  void near_forces() override;
  ViscousSolve advance_velocity(const VelocityTolerance& tolerance, int most_iterations) override;
  void near_motion() override;
  void set_sound_speed(double c0) override;

 protected:
  void list_pairs() override;
  void prepare_rows() override;
  void fluid_near(std::size_t self, std::vector<std::uint32_t>& near) const override;
  const std::vector<Vec3d>& listed_positions() const override { return age_.start_positions(); }
  void fill_by_shifts(double dt) override;

 private:
  void set_scale();
  void pack_motion();
  void pack_stress();
  void pack_near_motion();
  void find_half_gradients();
  void multiply(const float* mass, const float* drag);

  const PairSweeps& sweeps_;
  double skin_;
  ListAge age_;
  Vec3d centre_;  // of all particles; zero of the integer positions
  PairScale scale_;
  PairList list_;
  std::size_t fluid_pairs_ = 0;     // listed by fluid particles
  std::size_t boundary_pairs_ = 0;  // listed by boundary particles
  std::vector<MotionRecord> motion_;
  std::vector<StressRecord> stress_records_;

  // Of the implicit method.
  std::vector<std::uint32_t> touched_walls_;  // boundary rows with a fluid particle that is awake
  std::vector<std::size_t> chunk_rows_;       // where each chunk of the list begins in awake_
  std::vector<FlowRecord> flow_;
  std::vector<float> wall_pressure_, wall_weight_;
  std::vector<ClosingRecord> closing_;  ///< by particle; of walls
  NearPairs near_;
  VelocityStep<float> velocity_step_;
  std::vector<ViscousRecord> viscous_;
  std::vector<VelocityGradient<float>> half_gradient_;
  std::vector<double> dots_;
};

}  // namespace sabo
