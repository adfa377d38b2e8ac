#pragma once

#include <optional>
#include <vector>

#include "backend/backend.hpp"
#include "backend/body_load_sum.hpp"
#include "backend/device/device_particles.hpp"
#include "backend/device/pair_sweeps.hpp"
#include "backend/device/pass_marks.hpp"
#include "backend/device/state_sums.hpp"
#include "backend/flow_view.hpp"
#include "backend/sweeps/flow_sums.hpp"
#include "backend/sweeps/implicit_sweeps.hpp"
#include "backend/velocity_step.hpp"

namespace sabo {

/// A backend whose arrays live in the memory of an executor and whose loops run there: written once
/// for graphics cards (backend/cuda) and for the host, where the tests run it. Particles are sorted
/// by column and height; pairs are listed with a skin, interleaved by slices of 32 particles; pair
/// sums are in single precision over exact position differences, state and sums over all particles
/// in double precision. Every sum has a fixed order.
///
/// fluid() and boundary() are copies on the host. They are fetched when they are asked for after a
/// change on the device, all fields at once, and handed back by find_neighbours() if they have been
/// asked for since the last change. So a reference is good until the next sweep or change of rows:
/// ask again then. Per step only its length and sums come to the host, the forces on particles of
/// bodies, and driven particles.
template <class Executor>
class DeviceBackend : public Backend {
 public:
  template <class T>
  using Array = typename Executor::template Array<T>;

  explicit DeviceBackend(const FlowModel& model, const Executor& on = Executor());

  Particles& fluid() override { return fetched(fluid_, fluid_copy_); }
  Particles& boundary() override { return fetched(boundary_, boundary_copy_); }
  KeptFluid keep_fluid() override;
  std::span<const Vec3d> positions() override;
  Places places() override;
  void change_boundary(const BoundaryChange& change) override;
  PassTimes& pass_times() override {
    pass_marks_.settle();
    return pass_times_;
  }

  void change_rows(const ParticleRows& rows,
                   const std::function<void(Particles&)>& change) override;
  Particles take_out(const ParticleRows& rows) override;
  ParticleRows driven_rows() const override;
  void change_driven(const std::function<void(Particles&)>& change) override;

  std::size_t fluid_count() const override { return count(fluid_, fluid_copy_); }
  std::size_t boundary_count() const override { return count(boundary_, boundary_copy_); }

  bool neighbours_are_stale(double margin) const override;
  double list_radius() const override { return model_.kernel_radius() + skin_; }
  void find_neighbours() override;

  void pressure() override;
  void strain_and_density_rates() override;
  void stress() override;
  void momentum() override;
  void extrapolate_to_boundary() override;

  void wall_pressure() override;
  void near_forces() override;
  void wall_resistance() override;
  void choose_step(const StepRule& rule, double longest) override;
  ChosenStep chosen_step() const override;
  ViscousSolve advance_velocity(const VelocityTolerance& tolerance, int most_iterations) override;
  void near_motion() override;
  void advance_state() override;
  void update_sleep() override;
  std::size_t asleep_count() const override {
    return list_position_.size() - awake_.size() - driven_.size();
  }
  void set_sound_speed(double c0) override;

  double fastest() const override;
  FlowHealth health() const override;
  const HeatAccount& heat() const override;
  const std::vector<BodyLoad>& body_loads() const override { return fetched_loads().loads(); }
  const std::vector<BodyForce>& body_forces() const override { return fetched_loads().forces(); }

  void predict() override;
  void correct() override;
  const std::vector<Vec3d>& accelerations() const override;
  const std::vector<double>& density_rates() const override;
  std::size_t device_bytes() const override;
  void archive(ArchiveWriter& a) override { archive_state(a); }
  void archive(ArchiveReader& a) override { archive_state(a); }

 protected:
  // Seen by tests.
  Array<WallShare> wall_share_;
  Array<double> wall_drag_, support_;
  Array<Filling> filling_;
  Array<Sym3<double>> strain_;

 private:
  friend struct FlowArrays;

  /// Times a pass on the device.
  struct Clock : PassMarks<Executor>::Clock {
    Clock(const DeviceBackend& backend, std::string_view name, std::uint64_t pairs = 0)
        : PassMarks<Executor>::Clock(backend.pass_marks_, name, pairs) {}
  };
  struct Copy {
    Particles particles;
    bool is_current = true;
    bool is_lent = false;     // the host may have changed it
    bool has_places = false;  // positions_copy_, of the fluid, is current
    bool is_kept = false;     // kept_, likewise, is current
    void outdate() { is_current = is_lent = has_places = is_kept = false; }
  };

  static std::size_t count(const DeviceParticles<Executor>& set, const Copy& copy) {
    return copy.is_lent ? copy.particles.size() : set.size();
  }
  Particles& fetched(DeviceParticles<Executor>& from, Copy& copy);
  void rows_change();
  FlowView view();
  PairRows rows() const;
  PairSums pair_sums() const { return {scale_, rows(), fluid_.size()}; }
  RecordPacker packer() const { return {model_, centre_, scale_}; }
  RowList awake() const { return {awake_.data(), awake_.size()}; }
  RowList driven() const { return {driven_.data(), driven_.size()}; }
  std::size_t all() const { return fluid_.size() + boundary_.size(); }
  template <class F>
  void over_awake(const F& f) const {
    on_.for_each(awake_.size(), AtRow<F>{awake_.data(), f});
  }
  /// A sweep over the pairs of some particles.
  template <class Sweep>
  void sweep_over(const Array<std::uint32_t>& particles, const Sweep& sweep) const {
    on_.sweep(particles.size(), SweepAtRow<Sweep>{particles.data(), sweep});
  }
  template <class F>
  void over_driven(const F& f) const {
    on_.for_each(driven_.size(), AtRow<F>{driven_.data(), f});
  }

  void fluid_changed() {
    fluid_copy_.outdate();
    state_sums_.reset();
  }
  const StateSums& state_sums() const;
  /// Into the account; f is to be summed up.
  template <class Heat, class F>
  void enter(std::size_t count, const F& f) {
    on_.template sum_up<Heat>(count, f, EnterHeat{account_.data()});
  }

  CloudBox box_of(const DeviceParticles<Executor>& set) const;
  void set_scale(CloudBox box, const CloudBox& boundary_box);
  struct SortedSet {
    ColumnLattice lattice;
    Array<std::uint32_t> first;
    Array<IntegerPlace> places;
  };
  SortedSet sort(DeviceParticles<Executor>& set, const CloudBox& box);
  void list_pairs();
  double relative_way() const;
  void list_bodies();
  BodyLoadSum& fetched_loads() const;
  void forget_results();
  void need_explicit_arrays();
  void need_implicit_arrays();
  void list_awake();
  void list_driven();
  void hold_driven();
  void hold_walls();
  void prepare_rows();
  void pack_motion();
  void pack_motion_beside();
  void shift_particles(double dt);
  template <class PairForce>
  void add_to_bodies(const PairForce& force);
  template <class Archive>
  void archive_state(Archive& a);
  void list_again(std::vector<Vec3d>& listed, const std::vector<std::uint32_t>& awake);

  Executor on_;
  mutable PassMarks<Executor> pass_marks_{on_, pass_times_};
  double skin_;
  Array<HalfSpace> half_space_;
  double yield_slope_;
  DeviceParticles<Executor> fluid_, boundary_;
  Copy fluid_copy_, boundary_copy_;

  SortedSet sorted_fluid_, sorted_boundary_;  // the latter while pairs are listed
  Vec3d centre_;                              // of all particles; zero of the integer positions
  PairScale scale_;
  Array<std::uint64_t> slice_starts_;
  Array<std::uint32_t> entries_, fluid_neighbours_, neighbours_;
  Array<Vec3d> list_position_;  // of the fluid when the list was made
  PairCount pairs_, swept_;     // listed, and those of awake_ and touched_
  bool has_list_ = false;
  mutable std::optional<StateSums> state_sums_;  // until the fluid changes

  Array<std::uint32_t> awake_;         // fluid particles that take part in the sweeps
  Array<std::uint32_t> touched_;       // boundary particles with one of them near
  Array<std::uint32_t> driven_;        // fluid particles that an inflow moves
  Array<std::uint32_t> driven_walls_;  // boundary particles that may be near those
  Array<char> has_neighbours_;
  Array<double> density_rate_, diffusion_rate_;
  Array<Vec3d> acceleration_;
  Array<MotionRecord> motion_;

  Array<ChosenStep> step_;  // one
  typename Executor::template StagingArray<ChosenStep> step_copy_;
  std::optional<typename Executor::Moment> step_then_;  // when step_copy_ is there

  // Of the method of the paper; empty until its sweeps run.
  Array<Sym3<double>> stress_;
  Array<double> pressure_power_, wall_heat_;
  Array<StressRecord> stress_records_;
  Array<Vec3d> start_position_, start_velocity_;
  Array<double> start_density_, start_boundary_density_;

  // Of the implicit method; empty until its sweeps run.
  Array<WallGrip> wall_grip_;
  Array<Vec3d> background_;
  Array<Shift> shift_;
  Array<double> artificial_heat_;
  Array<FlowRecord> flow_records_;
  Array<float> wall_weight_;
  Array<ClosingRecord> closings_;
  VelocityStep<float, Executor> velocity_step_;
  Array<VelocityGradient<float>> half_gradient_;  // of the direction of the solve; zero at no row
  Array<HeatAccount> account_;                    // one
  mutable std::vector<HeatAccount> account_copy_;

  Array<std::uint32_t> body_rows_;  // boundary particles of bodies
  Array<Vec3d> row_forces_;         // on each of them, N
  mutable BodyLoadSum body_loads_;  // of row_forces_, once they are fetched
  typename Executor::template StagingArray<Vec3d> row_forces_copy_;
  mutable std::optional<typename Executor::Moment> new_forces_then_;  // when that has new ones

  StagedParticles<Executor> staged_;
  // When staged_ is there. Not in what kept_ holds, which may end in any thread.
  std::optional<typename Executor::Moment> kept_then_;
  KeptFluid kept_;  // out of staged_, once somebody has waited for it; until the next

  typename Executor::template StagingArray<Vec3d> positions_copy_;
  std::vector<std::uint32_t> ids_copy_;  // empty until they are asked for in the present order
  std::vector<double> masses_copy_;
  mutable std::vector<Vec3d> accelerations_copy_;
  mutable std::vector<double> density_rates_copy_;
};

}  // namespace sabo
