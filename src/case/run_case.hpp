#pragma once

#include "base/describe.hpp"

namespace sabo {

struct RunCase {
  double duration = 0;
  double output_interval = 5;
  double series_interval = 0.5;
  double checkpoint_interval = 600;
  double kept_checkpoint_interval = 0;
  bool stop_at_rest = true;
  double rest_time = 10;
  double rest_speed = 0.01;
  double rest_volume = 0.01;
  double rest_energy = 1e-4;
  double rest_creep = 1;

  template <class V>
  void describe(V&& v) {
    v(Key{"duration", "s", "simulated time; less when the flow comes to rest before"}
          .above(0)
          .at_most(1e7)
          .required(),
      duration);
    v(Key{"output_interval", "s", "between frames"}.above(0).at_most(1e7), output_interval);
    v(Key{"series_interval", "s", "between rows of the series"}.above(0).at_most(1e7),
      series_interval);
    v(Key{"checkpoint_interval", "s",
          "wall-clock time between checkpoints, from which sabo run --resume goes on; 0: none at "
          "all"}
          .at_least(0)
          .at_most(1e7),
      checkpoint_interval);
    v(Key{"kept_checkpoint_interval", "s",
          "simulated time between checkpoints that are kept for sabo run --branch-at; 0: none but "
          "the last"}
          .at_least(0)
          .at_most(1e7),
      kept_checkpoint_interval);
    v(Key{"stop_at_rest", "",
          "end the run when the flow has moved and the following limits hold, all at once"},
      stop_at_rest);
    v(Key{"rest_time", "s",
          "how long all limits below must hold; displacements are measured over it"}
          .above(0)
          .at_most(1e7),
      rest_time);
    v(Key{"rest_speed", "m/s", "displacement over rest_time above which a particle moves"}
          .above(0)
          .at_most(100),
      rest_speed);
    v(Key{"rest_volume", "", "share of the released volume that may still move"}
          .at_least(0)
          .at_most(1),
      rest_volume);
    v(Key{"rest_energy", "", "greatest kinetic energy, as a share of its peak"}.at_least(0).at_most(
          1),
      rest_energy);
    v(Key{"rest_creep", "spacings/min", "greatest mean displacement of the mass"}
          .at_least(0)
          .at_most(1e6),
      rest_creep);
  }
};

}  // namespace sabo
