#pragma once

#include <cstdint>
#include <vector>

#include "analysis/basin.hpp"
#include "analysis/energy.hpp"
#include "analysis/front.hpp"
#include "analysis/rest.hpp"
#include "analysis/section.hpp"
#include "analysis/volume_ledger.hpp"
#include "analysis/zone.hpp"
#include "backend/heat_account.hpp"

namespace sabo {

/// What has come through an inflow since the start.
struct InflowRow {
  double entered = 0;     ///< m3
  double hydrograph = 0;  ///< m3 that its hydrograph has brought by then

  template <class Archive>
  void archive(Archive& a) {
    a(entered, hydrograph);
  }
};

/// Loads on a structure since the row before.
struct LoadRow {
  double force = 0;                     ///< horizontal, N
  double hydrostatic = 0, dynamic = 0;  ///< by the design formulas, N
};

/// What the last step was like.
struct SolverRow {
  double steps = 0;              ///< since the start
  double dt = 0;                 ///< s
  double fastest = 0;            ///< m/s
  double min_density_ratio = 1;  ///< of the fluid, rho / rho0
  double max_density_ratio = 1;
  double fluid = 0, boundary = 0, asleep = 0;  ///< particles
  double sound_speed = 0;                      ///< m/s
  double iterations = 0;                       ///< of the viscous solve
};

/// One row of the series, kept for the pictures.
struct SeriesRow {
  double time = 0;
  FrontRow front;
  std::vector<double> discharge;       ///< net, mean since the row before, m3/s; one per section
  std::vector<SectionVolumes> passed;  ///< since the start; one per section
  std::vector<VolumeRow> volumes;      ///< one entry per check dam, or one alone without
  std::vector<ZoneDepth> zones;        ///< one entry per zone
  std::vector<BasinState> basins;      ///< one entry per check dam
  std::vector<LoadRow> loads;          ///< one entry per dam, then per body
  std::vector<InflowRow> inflows;      ///< one entry per inflow
  Energy energy;
  Energy entered;         ///< brought by inflows so far
  Energy left;            ///< of what has left the map, at the time it did
  double dissipated = 0;  ///< J
  NumericalHeat numerical;
  MotionState motion;
  SolverRow solver;

  template <class Archive>
  void archive(Archive& a) {
    a(time, front, discharge, passed, volumes, zones, basins, loads, inflows, energy, entered, left,
      dissipated, numerical, motion, solver);
  }
};

}  // namespace sabo
