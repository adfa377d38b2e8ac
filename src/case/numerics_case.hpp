#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "base/describe.hpp"
#include "physics/switches.hpp"

namespace sabo {

enum class Method { fast, paper };
template <>
struct Words<Method> {
  static constexpr std::array<std::string_view, 2> list{"fast", "paper"};
};

/// Which fluids bear tension beside the air.
enum class TensionAtSurface { by_law, borne, none };
template <>
struct Words<TensionAtSurface> {
  static constexpr std::array<std::string_view, 3> list{"by_law", "borne", "none"};
};

enum class WallLaw { no_slip, coulomb, voellmy, slip };
template <>
struct Words<WallLaw> {
  static constexpr std::array<std::string_view, 4> list{"no_slip", "coulomb", "voellmy", "slip"};
};

enum class BackendKind { reference, cpu, cuda };
template <>
struct Words<BackendKind> {
  static constexpr std::array<std::string_view, 3> list{"reference", "cpu", "cuda"};
};

struct NumericsCase {
  double spacing = 0;
  Method method = Method::fast;
  BackendKind backend = BackendKind::cpu;
  int threads = 0;
  double h_over_dp = 1.5;
  double sound_speed_factor = 10;
  std::optional<double> h_max;
  double reference_speed = 0;
  double density_diffusion = 0.1;
  DiffusionForm diffusion_form = DiffusionForm::fourtakas;
  double artificial_viscosity = 0;
  ViscousOperator viscous_operator = ViscousOperator::nested;
  BoundaryStress boundary_stress = BoundaryStress::own;
  BoundaryPressure boundary_pressure = BoundaryPressure::dynamic;
  bool as_printed = false;
  double cfl = 0.6;
  std::optional<double> viscous_cfl;
  double viscous_tolerance = 1e-3;
  int viscous_iterations = 100;
  bool adaptive_sound_speed = true;
  WallLaw wall = WallLaw::no_slip;
  double wall_friction_angle = 0;
  double wall_cohesion = 0;
  double wall_turbulence = 500;
  double sleep_speed = 0.005;
  double sleep_time = 0.5;
  double crowding_tolerance = 0.03;
  TensionAtSurface tension_at_surface = TensionAtSurface::by_law;
  std::optional<double> particle_shifting;
  double gravity = 9.81;

  template <class V>
  void describe(V&& v) {
    v(Key{"spacing", "m",
          "initial distance of particles dp; the flow should be at least 4 particles deep"}
          .at_least(1e-6)
          .at_most(1e4)
          .required(),
      spacing);
    v(Key{"method", "",
          "fast, with implicit viscosity and wall friction in large steps, or paper, as published "
          "in "
          "2016"},
      method);
    if constexpr (SetsMembers<V>) take_method();
    v(Key{"backend", "",
          "where the particle loops run: cpu, cuda (an NVIDIA graphics card), or reference "
          "(serial, all pairs)"},
      backend);
    v(Key{"threads", "", "number of threads; 0 takes all. The results do not depend on it"}
          .at_least(0)
          .at_most(1024),
      threads);
    v(Key{"h_over_dp", "", "smoothing length over spacing"}.at_least(1).at_most(3), h_over_dp);
    v(Key{"sound_speed_factor", "", "beta in c0 = beta sqrt(g h_max)"}.at_least(1).at_most(1000),
      sound_speed_factor);
    v(Key{"h_max", "m",
          "depth that sets the sound speed; default: the greatest of the release and the inflows"}
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
          "gradient of a fluid at rest alone; default molteni with method paper, else fourtakas"},
      diffusion_form);
    v(Key{"artificial_viscosity", "", "Monaghan's alpha; for water cases 0.01 to 0.05"}
          .at_least(0)
          .at_most(10),
      artificial_viscosity);
    v(Key{"viscous_operator", "",
          "paper: nested: divergence of the stress tensor (Eq. 18); morris: two-point (Morris "
          "1997)"},
      viscous_operator);
    v(Key{"boundary_stress", "",
          "paper: stress that boundary particles carry: own, mirror (own, with the wall moving "
          "against the flow) or none; it decides the mobility"},
      boundary_stress);
    v(Key{"boundary_pressure", "",
          "paper: dynamic, boundary particles obey continuity; extrapolated, from the fluid near "
          "them, as the fast method does"},
      boundary_pressure);
    v(Key{"as_printed", "", "keep the printed factor 1/2 of Eqs. 16-17, which halves viscosity"},
      as_printed);
    v(Key{"cfl", "",
          "acoustic time step over h / (c0 + v), default 0.6; with method paper over "
          "h / max(c0, 10 v), default 0.2"}
          .above(0)
          .at_most(1.5),
      cfl);
    v(Key{"viscous_cfl", "",
          "paper: viscous time step over h^2 rho / mu; default 0.6 (nested), 1.2 (as_printed), "
          "0.23 (morris)"}
          .above(0)
          .at_most(10),
      viscous_cfl);
    v(Key{"viscous_tolerance", "",
          "fast: residual of the implicit viscosity, as a share of what gravity adds in a step"}
          .above(0)
          .at_most(1),
      viscous_tolerance);
    v(Key{"viscous_iterations", "",
          "fast: most iterations of the implicit viscosity; beyond them the step is halved"}
          .at_least(1)
          .at_most(10000),
      viscous_iterations);
    v(Key{"adaptive_sound_speed", "",
          "fast: the sound speed follows the fastest flow, down to that of the depth and of "
          "reference_speed"},
      adaptive_sound_speed);
    v(Key{"wall", "",
          "fast: shear between flow and ground, structures or bodies: no_slip (that of the "
          "material), coulomb, "
          "voellmy (coulomb and turbulence) or slip"},
      wall);
    v(Key{"wall_friction_angle", "deg", "of coulomb and voellmy, on the effective pressure"}
          .at_least(0)
          .at_most(60),
      wall_friction_angle);
    v(Key{"wall_cohesion", "Pa", "of coulomb and voellmy"}.at_least(0).at_most(1e9), wall_cohesion);
    v(Key{"wall_turbulence", "m/s2", "xi of voellmy: adds the stress rho g v^2 / xi"}
          .above(0)
          .at_most(1e9),
      wall_turbulence);
    v(Key{"sleep_speed", "m/s",
          "fast: material with a yield stress that is slower than this and below yield falls "
          "asleep, and wakes when material near it moves; 0: never"}
          .at_least(0)
          .at_most(1),
      sleep_speed);
    v(Key{"sleep_time", "s",
          "fast: how long it must have been slower than sleep_speed and below yield"}
          .above(0)
          .at_most(1e6),
      sleep_time);
    v(Key{"crowding_tolerance", "",
          "fast: difference between density and the places of the particles, as a share, beyond "
          "which density follows the places"}
          .above(0)
          .at_most(1),
      crowding_tolerance);
    v(Key{"tension_at_surface", "",
          "fast: whether pressure may be negative near a free surface too (borne) or only inside "
          "of the flow (none); by_law: borne by laws with a yield stress"},
      tension_at_surface);
    v(Key{"particle_shifting", "",
          "fast: inside of the flow particles are shifted to more even places, by this times h^2, "
          "the shear strain of the step and the gradient of the filling of their kernel; 0: not; "
          "default 40 for laws with a yield stress, 20 for others"}
          .at_least(0)
          .at_most(1000),
      particle_shifting);
    v(Key{"gravity", "m/s2", "acceleration of gravity, downwards"}.at_least(0).at_most(1000),
      gravity);
  }

 private:
  /// The defaults that a method brings along.
  void take_method() {
    const bool is_paper = method == Method::paper;
    diffusion_form = is_paper ? DiffusionForm::molteni : DiffusionForm::fourtakas;
    cfl = is_paper ? 0.2 : 0.6;
  }
};

}  // namespace sabo
