#pragma once

#include <array>
#include <span>
#include <string_view>

#include "base/describe.hpp"

namespace sabo {

/// A quantity as a run at one spacing gave it.
struct GridSample {
  double spacing = 0;  ///< m, positive
  double value = 0;    ///< finite
};

/// How a quantity changes with the spacing.
enum class Convergence {
  single,       ///< one spacing: nothing can be said
  first_order,  ///< two spacings: first order is an assumption
  monotone,     ///< the changes keep their sign and shrink: the order is observed
  unchanged,    ///< the same at all of them
  no_order      ///< the changes alternate or do not shrink: no order can be given
};
template <>
struct Words<Convergence> {
  static constexpr std::array<std::string_view, 5> list{"single", "first order assumed", "monotone",
                                                        "unchanged", "no order"};
};

/// What a series of spacings says about the spacing of zero.
struct GridConvergence {
  Convergence kind = Convergence::single;
  double lowest = 0;  ///< of all values
  double highest = 0;
  // Of first_order, monotone and unchanged:
  double order = 0;         ///< p of value = limit + C spacing^p; 0 of unchanged
  double extrapolated = 0;  ///< at the spacing of zero
  double uncertainty = 0;   ///< of the value at the finest spacing, +-: the grid convergence index
  bool has_limit() const {
    return kind == Convergence::first_order || kind == Convergence::monotone ||
           kind == Convergence::unchanged;
  }
};

/// Greatest order that the grid convergence index takes: sums over SPH neighbours are of second
/// order at best, and a higher observed one would claim a precision that chance gave.
inline constexpr double greatest_trusted_order = 2;

/// Generalised Richardson extrapolation over the three finest of the samples, in any order, with
/// different spacings. Their ratios need not be equal; the observed order solves
///   (h3^p - h2^p) / (h2^p - h1^p) = (f3 - f2) / (f2 - f1),   h1 < h2 < h3.
/// The grid convergence index (Roache 1994; Celik et al. 2008, J. Fluids Eng. 130, 078001) is
///   Fs |f2 - f1| / ((h2/h1)^p - 1),   Fs = 1.25 with three spacings and 3 with two.
GridConvergence grid_convergence(std::span<const GridSample> samples);

/// Mean and standard deviation of a sample (over n - 1; 0 of one value).
struct Scatter {
  double mean = 0;
  double deviation = 0;
};
Scatter scatter_of(std::span<const double> values);

}  // namespace sabo
