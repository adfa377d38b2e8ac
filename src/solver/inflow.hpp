#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "case/hydrograph.hpp"
#include "particles/particles.hpp"
#include "physics/equation_of_state.hpp"
#include "terrain/inflow_section.hpp"

namespace sabo {

/// What an inflow is, before it starts.
struct InflowPlan {
  std::string name;
  Polyline line;  ///< solver frame
  InflowSection section;
  Hydrograph hydrograph;
  double froude = 1;  ///< where the hydrograph has no speeds
  double spacing = 1;
  double reach = 3;       ///< length beyond the line over which particles are driven, m
  double density = 1000;  ///< kg/m3
  double gravity = 9.81;  ///< m/s2

  /// Of one particle: a column's width times the square of the spacing, m3.
  double particle_volume() const { return section.column_width() * spacing * spacing; }
  /// What flows through the section at a time; nothing where there is no discharge.
  SectionFlow flow_at(double time) const;
  /// The same at the greatest discharge.
  SectionFlow flow_at_peak() const;
  /// The same when the level is highest.
  SectionFlow highest_flow() const;
  /// Particles that have come until a time, to the nearest.
  std::size_t particles_until(double time) const;
  /// Of what comes in at a time, along the bed, m/s: that of flow_at(), but where it follows from
  /// depth at least that of a flow one spacing deep, which is as thin as particles can tell.
  double speed_at(double time) const;
};

/// A discharge that comes in through a section, after the open boundaries of Tafuni et al. (2018),
/// with a buffer that lies in front of the line, where there is ground.
///
/// Particles come in layers across the section, one each time the last has moved on by a spacing.
/// For the next `reach`, more than the radius of the kernel, they are driven: their velocity, one
/// for all and along the bed, and the pressure of their depth are given. What is beyond has
/// neighbours behind it that push, and flows freely.
///
/// A layer has as many particles as the hydrograph has brought since the one before, to the nearest
/// particle; what is left counts in the next one. So at each layer the volume that has entered is
/// that of the hydrograph to half a particle, and between layers it is behind by what the next one
/// brings. They take the lowest places above the bed that are free, as water fills a section; which
/// columns have one more follows a sequence of low discrepancy, another in each layer.
class Inflow {
 public:
  /// `number` marks its particles, from 1. The plan must outlive the inflow.
  Inflow(const InflowPlan& plan, std::uint16_t number);

  /// What a step has changed.
  struct Change {
    std::vector<std::uint32_t> entered;  ///< rows of the particles that have come, the last ones
    std::vector<std::uint32_t> freed;    ///< rows of those that were set free
  };

  /// Whether the last layer will have moved on by a spacing after a step of `dt` (s).
  bool layer_is_due(double dt) const { return moved_ + dt * advance_ >= plan_.spacing; }

  /// Whether a free particle may be too near to where a layer is about to come.
  bool may_be_in_the_way(const Vec3d& place) const;

  /// The fluid has made a step of `dt` (s) to `time` (s): keeps driven particles on the bed, and if
  /// a layer is due sets those free that are through and brings it, with ids from `next_id` on.
  /// Sets the velocity of the next step. `fluid` need hold no others than those that are driven
  /// and, for a layer, those that may be in its way.
  Change advance(Particles& fluid, const Tait& state, double time, double dt,
                 std::uint32_t& next_id);

  std::size_t count() const { return count_; }  ///< particles that have come
  double entered() const;                       ///< their volume, m3
  /// Whether all has come and is free.
  bool is_over(double time) const;
  const InflowPlan& plan() const { return plan_; }

  template <class Archive>
  void archive(Archive& a) {
    a(count_, layers_, driven_, moved_, advance_);
  }

 private:
  double owed(double time) const;
  void follow_bed(Particles& fluid, double dt) const;
  std::vector<std::uint32_t> set_free(Particles& fluid);
  void add_layer(Particles& fluid, const Tait& state, std::size_t count, std::uint32_t& next_id);
  void set_velocity(Particles& fluid) const;

  const InflowPlan& plan_;
  std::uint16_t number_;
  std::size_t count_ = 0;     // particles that have come
  std::uint64_t layers_ = 0;  // that have come
  std::size_t driven_ = 0;    // particles at present
  double moved_ = 0;          // of the last layer since it came, in plan, m
  double advance_ = 0;        // horizontal speed of driven particles, m/s
};

}  // namespace sabo
