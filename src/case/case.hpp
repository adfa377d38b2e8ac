#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/describe.hpp"
#include "physics/rheology_list.hpp"
#include "physics/switches.hpp"
#include "physics/yield.hpp"

namespace sabo {

// The case as plain structs. Each member is described once, here; see base/describe.hpp. A line is
// given by a vector file (`line = "dam.gpkg"`) or by coordinates (`line = [[x, y], ...]`, a third
// number is z); both are in the coordinates of the DEM, files in another CRS are reprojected.

/// Vector file or coordinates; exactly one is set when the key was given.
/// File paths of a case are absolute once it has been read.
struct LineSource {
  std::filesystem::path file;
  std::vector<std::array<double, 3>> coordinates;
  bool has_z = false;  ///< of `coordinates`
  bool given() const { return !file.empty() || !coordinates.empty(); }
};

struct TerrainCase {
  std::filesystem::path dem;
  bool assume_metres = false;
  std::optional<std::array<double, 4>> crop;
  double fill_holes = 25;

  template <class V>
  void describe(V&& v) {
    v(Key{"dem", "", "elevation raster, any format of GDAL; its CRS must be projected, in metres"}
          .required(),
      dem);
    v(Key{"assume_metres", "", "take a raster without a CRS as metres"}, assume_metres);
    v(Key{"crop", "m", "keep this window only: [west, south, east, north] in CRS coordinates"}
          .at_least(-1e8)
          .at_most(1e8),
      crop);
    v(Key{"fill_holes", "cells",
          "enclosed areas without data up to this size are filled from their rim; larger ones "
          "are outside the domain"}
          .at_least(0)
          .at_most(1e9),
      fill_holes);
  }
};

struct ReleaseCase {
  LineSource polygon;
  std::filesystem::path thickness_raster;
  std::filesystem::path points;
  std::array<double, 3> points_offset{0, 0, 0};
  double point_volume = 1;
  std::optional<double> thickness;
  std::optional<double> volume;
  bool normal = false;

  template <class V>
  void describe(V&& v) {
    v(Key{"polygon", "", "release area: a vector file or coordinates; needs thickness or volume"},
      polygon);
    v(Key{"thickness_raster", "m", "raster of release thickness in the CRS of the DEM"},
      thickness_raster);
    v(Key{"points", "", "text file of points x y z, each the centre of point_volume"}, points);
    v(Key{"points_offset", "m", "added to the points"}.at_least(-1e8).at_most(1e8), points_offset);
    v(Key{"point_volume", "m3", "volume each point stands for"}.above(0).at_most(1e9),
      point_volume);
    v(Key{"thickness", "m", "release thickness of the polygon"}.above(0).at_most(1e4), thickness);
    v(Key{"volume", "m3", "release volume; scales the polygon's thickness or the raster"}
          .above(0)
          .at_most(1e12),
      volume);
    v(Key{"normal", "", "thickness is normal to the ground, not vertical"}, normal);
  }
};

struct MaterialCase {
  double density = 1726;
  Rheology law = Cross{};
  MohrCoulomb yield;  ///< used by laws with a yield stress

  template <class V>
  void describe(V&& v) {
    v(Key{"density", "kg/m3", "bulk density of the mixture"}.at_least(1).at_most(3e4), density);
    // A visitor that reads sets the law here, so that what follows are the keys of that law.
    v(Key{"rheology", "", "law of flow; `sabo models` lists them with their keys"}, law);
    std::visit([&](auto& chosen) { chosen.describe(v); }, law);
    if (has_yield(law)) yield.describe(v);
  }
};

struct NotchCase {
  double centre = 0;
  double width = 0;
  double depth = 0;
  double side_slope = 0;

  template <class V>
  void describe(V&& v) {
    v(Key{"centre", "m", "of the notch, as distance along the line"}
          .at_least(0)
          .at_most(1e6)
          .required(),
      centre);
    v(Key{"width", "m", "of the notch at its sill"}.above(0).at_most(1e5).required(), width);
    v(Key{"depth", "m", "of the sill below the crest"}.above(0).at_most(1e4).required(), depth);
    v(Key{"side_slope", "", "horizontal run of the notch's sides for 1 m of rise"}
          .at_least(0)
          .at_most(100),
      side_slope);
  }
};

enum class StructureKind { check_dam };
template <>
struct Words<StructureKind> {
  static constexpr std::array<std::string_view, 1> list{"check_dam"};
};

struct StructureCase {
  std::string name;
  StructureKind kind = StructureKind::check_dam;
  LineSource line;
  std::optional<double> crest;
  std::optional<double> height;
  double thickness = 0;
  std::optional<NotchCase> notch;

  template <class V>
  void describe(V&& v) {
    v(Key{"name", "", "used in the outputs"}, name);
    v(Key{"kind", "", "check_dam: a wall from the ground up to its crest"}, kind);
    v(Key{"line", "", "axis of the dam: a vector file or coordinates; z, if any, is its crest"}
          .required(),
      line);
    v(Key{"crest", "m", "elevation of the crest"}.at_least(-1e4).at_most(1e4), crest);
    v(Key{"height", "m", "of the crest above the lowest ground along the line"}.above(0).at_most(
          1e4),
      height);
    v(Key{"thickness", "m", "along the flow"}.above(0).at_most(1e4).required(), thickness);
    v(Key{"notch", "", "spillway cut into the crest"}, notch);
  }
};

struct SectionCase {
  std::string name;
  LineSource line;

  template <class V>
  void describe(V&& v) {
    v(Key{"name", "", "used in the outputs"}, name);
    v(Key{"line", "",
          "section for discharge, positive from left to right looking from its first vertex to "
          "its last: a vector file or coordinates"}
          .required(),
      line);
  }
};

struct PathCase {
  LineSource line;

  template <class V>
  void describe(V&& v) {
    v(Key{"line", "",
          "line along the valley for the front; without it, steepest descent from the release"},
      line);
  }
};

enum class Method { paper };
template <>
struct Words<Method> {
  static constexpr std::array<std::string_view, 1> list{"paper"};
};

enum class BackendKind { reference, cpu };
template <>
struct Words<BackendKind> {
  static constexpr std::array<std::string_view, 2> list{"reference", "cpu"};
};

struct NumericsCase {
  double spacing = 0;
  Method method = Method::paper;
  BackendKind backend = BackendKind::cpu;
  int threads = 0;
  double h_over_dp = 1.5;
  double sound_speed_factor = 10;
  std::optional<double> h_max;
  double reference_speed = 0;
  double density_diffusion = 0.1;
  DiffusionForm diffusion_form = DiffusionForm::molteni;
  double artificial_viscosity = 0;
  ViscousOperator viscous_operator = ViscousOperator::nested;
  BoundaryStress boundary_stress = BoundaryStress::own;
  bool as_printed = false;
  double cfl = 0.2;
  std::optional<double> viscous_cfl;
  double gravity = 9.81;

  template <class V>
  void describe(V&& v) {
    v(Key{"spacing", "m", "initial distance of particles dp; the flow should be 4 or more deep"}
          .at_least(1e-6)
          .at_most(1e4)
          .required(),
      spacing);
    v(Key{"method", "", "paper: weakly compressible SPH as published in 2016"}, method);
    v(Key{"backend", "", "where the particle loops run: cpu, or reference (serial, all pairs)"},
      backend);
    v(Key{"threads", "", "number of threads; 0 takes all. The results do not depend on it"}
          .at_least(0)
          .at_most(1024),
      threads);
    v(Key{"h_over_dp", "", "smoothing length over spacing"}.at_least(1).at_most(3), h_over_dp);
    v(Key{"sound_speed_factor", "", "beta in c0 = beta sqrt(g h_max)"}.at_least(1).at_most(1000),
      sound_speed_factor);
    v(Key{"h_max", "m", "depth that sets the sound speed; default: the greatest release depth"}
          .above(0)
          .at_most(1e5),
      h_max);
    v(Key{"reference_speed", "m/s",
          "fastest speed expected: the sound speed is at least beta times this"}
          .at_least(0)
          .at_most(1e4),
      reference_speed);
    v(Key{"density_diffusion", "", "zeta of the delta-SPH term (Eq. 11)"}.at_least(0).at_most(1),
      density_diffusion);
    v(Key{"diffusion_form", "",
          "molteni: as published, a thin layer swells over seconds; fourtakas: leaves the density "
          "gradient of a fluid at rest alone"},
      diffusion_form);
    v(Key{"artificial_viscosity", "", "Monaghan's alpha; for water cases 0.01 to 0.05"}
          .at_least(0)
          .at_most(10),
      artificial_viscosity);
    v(Key{"viscous_operator", "",
          "nested: divergence of the stress tensor (Eq. 18); morris: two-point (Morris 1997)"},
      viscous_operator);
    v(Key{"boundary_stress", "",
          "stress that boundary particles carry: own, mirror (own, with the wall moving against "
          "the flow) or none; it decides the mobility"},
      boundary_stress);
    v(Key{"as_printed", "", "keep the printed factor 1/2 of Eqs. 16-17, which halves viscosity"},
      as_printed);
    v(Key{"cfl", "", "acoustic time step over h / max(c0, 10 v)"}.above(0).at_most(1.5), cfl);
    v(Key{"viscous_cfl", "",
          "viscous time step over h^2 rho / mu; default 0.6 (nested), 1.2 (as_printed), "
          "0.23 (morris)"}
          .above(0)
          .at_most(10),
      viscous_cfl);
    v(Key{"gravity", "m/s2", "acceleration of gravity, downwards"}.at_least(0).at_most(1000),
      gravity);
  }
};

struct RunCase {
  double duration = 0;
  double output_interval = 5;
  double series_interval = 0.5;

  template <class V>
  void describe(V&& v) {
    v(Key{"duration", "s", "simulated time"}.above(0).at_most(1e7).required(), duration);
    v(Key{"output_interval", "s", "between frames"}.above(0).at_most(1e7), output_interval);
    v(Key{"series_interval", "s", "between rows of the series"}.above(0).at_most(1e7),
      series_interval);
  }
};

/// Volumes known from elsewhere, printed beside those of the run.
struct ReferenceCase {
  std::string name;
  std::optional<double> released;
  std::optional<double> trapped;
  std::optional<double> beyond;

  template <class V>
  void describe(V&& v) {
    v(Key{"name", "", "source of the volumes, e.g. a survey"}.required(), name);
    v(Key{"released", "m3", "volume that started to move"}.at_least(0).at_most(1e12), released);
    v(Key{"trapped", "m3", "volume held above the dam"}.at_least(0).at_most(1e12), trapped);
    v(Key{"beyond", "m3", "volume that passed the dam"}.at_least(0).at_most(1e12), beyond);
  }
};

struct Case {
  std::string title;
  std::string note;  ///< shown wherever the results are shown, e.g. "generated terrain"
  TerrainCase terrain;
  ReleaseCase release;
  MaterialCase material;
  std::vector<StructureCase> structures;
  std::vector<SectionCase> sections;
  PathCase path;
  std::vector<ReferenceCase> references;
  NumericsCase numerics;
  RunCase run;
  std::filesystem::path folder;  ///< of the case file, absolute; relative paths start here

  /// Calls v.table(name, help, struct) and v.tables(name, help, vector of structs).
  template <class V>
  void describe(V&& v) {
    v(Key{"title", "", "one line, shown in the outputs"}, title);
    v(Key{"note", "", "shown wherever the results are shown, e.g. where the terrain comes from"},
      note);
    v.table("terrain", "the ground", terrain);
    v.table("release", "the mass that starts to move", release);
    v.table("material", "its density and law of flow", material);
    v.tables("structure", "works in the way", structures);
    v.tables("section", "lines that measure discharge", sections);
    v.table("path", "the line along which the front is measured", path);
    v.tables("reference", "volumes known from elsewhere, printed beside the run's", references);
    v.table("numerics", "the method", numerics);
    v.table("run", "how long, and what is written", run);
  }
};

}  // namespace sabo
