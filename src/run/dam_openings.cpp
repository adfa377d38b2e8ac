#include "run/dam_openings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "base/error.hpp"

namespace sabo {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double most_openings = 10'000;  // of one grid

/// A stretch of the line of a dam and the key that says so.
struct Stretch {
  double from = 0;
  double to = 0;
  std::string key;
};

void refuse_unless_within(const CheckDam& dam, const Stretch& stretch) {
  const double end = length(dam.axis);
  const double rounding = 1e-6 * (1 + end);
  if (stretch.from >= -rounding && stretch.to <= end + rounding) return;
  throw CaseError(
      stretch.key,
      fmt::format("reaches from {:g} to {:g} m along the line", stretch.from, stretch.to),
      fmt::format("the line is {:.2f} m long: stay within it", end));
}

/// Calls visit(station) at places no farther apart than half a cell.
template <class Visit>
void for_each_station(const Surface& surface, const Stretch& stretch, Visit&& visit) {
  const Grid& grid = surface.elevation().grid;
  const double step = std::min(grid.dx, grid.dy) / 2;
  const double steps = std::clamp(std::ceil((stretch.to - stretch.from) / step), 1.0, 1e5);
  for (int k = 0; k <= steps; ++k) visit(stretch.from + (stretch.to - stretch.from) * k / steps);
}

/// Under the axis and both faces, m.
double lowest_ground(const CheckDam& dam, const Surface& surface, const Stretch& stretch) {
  double lowest = infinity;
  for_each_station(surface, stretch, [&](double station) {
    const Vec3d foot = point_at(dam.axis, station);
    const Vec3d along = direction_at(dam.axis, station);
    for (const double offset : {-dam.thickness / 2, 0.0, dam.thickness / 2})
      lowest =
          std::min(lowest, surface.height(foot.x - offset * along.y, foot.y + offset * along.x));
  });
  return lowest;
}

double highest_crest(const CheckDam& dam, const Surface& surface, const Stretch& stretch) {
  double highest = -infinity;
  for_each_station(surface, stretch,
                   [&](double station) { highest = std::max(highest, dam.top(station)); });
  return highest;
}

/// Where an opening begins.
struct Sill {
  double bottom = -infinity;  ///< elevation, m
  double base = 0;            ///< elevation that heights count from, m: the ground or the sill
};

Sill sill_of(const SillCase& c, const CheckDam& dam, const Surface& surface,
             const Stretch& stretch) {
  const double ground = lowest_ground(dam, surface, stretch);
  Sill sill{-infinity, ground};
  if (c.elevation) sill = {*c.elevation, std::max(*c.elevation, ground)};
  if (c.height && *c.height > 0) sill = {ground + *c.height, ground + *c.height};
  const double crest = highest_crest(dam, surface, stretch);
  if (sill.base >= crest) {
    throw CaseError(
        stretch.key,
        fmt::format("the opening begins at {:.2f} m, which is not below the crest at {:.2f} m",
                    sill.base, crest),
        "give a lower sill, or a higher dam");
  }
  return sill;
}

Opening slit_opening(const SlitCase& c, const CheckDam& dam, const Surface& surface,
                     const std::string& key) {
  const Stretch stretch{c.centre - c.width / 2, c.centre + c.width / 2, key};
  refuse_unless_within(dam, stretch);
  const Sill sill = sill_of(c.sill, dam, surface, stretch);
  return {stretch.from, stretch.to, sill.bottom, c.height ? sill.base + *c.height : infinity};
}

/// Upright pieces of the gaps between posts, under and over the beams.
std::vector<DamPart> between_beams(const GridCase& c, const Sill& sill, double crest) {
  if (!c.beam_gap || !c.beam_height) return {{sill.bottom, infinity}};
  std::vector<DamPart> parts;
  const double pitch = *c.beam_gap + *c.beam_height;
  for (int k = 0; sill.base + k * pitch < crest; ++k) {
    const double bottom = sill.base + k * pitch;
    parts.push_back({k == 0 ? sill.bottom : bottom, bottom + *c.beam_gap});
  }
  return parts;
}

void add_grid(const GridCase& c, const CheckDam& dam, const Surface& surface,
              const std::string& key, std::vector<Opening>& openings) {
  const GridLayout layout = grid_layout(c);
  const double end = layout.from(layout.gaps - 1) + c.gap;
  const Stretch stretch{layout.first, end, key};
  refuse_unless_within(dam, {c.from, c.to, key});
  const Sill sill = sill_of(c.sill, dam, surface, stretch);
  const double crest = highest_crest(dam, surface, stretch);
  const double rows = c.beam_gap ? (crest - sill.base) / *c.beam_gap : 1;
  if (layout.gaps * rows > most_openings)
    throw CaseError(key, fmt::format("has more than {:g} gaps", most_openings),
                    "check its stretch, gap and beam_gap");
  for (const DamPart& part : between_beams(c, sill, crest)) {
    for (int k = 0; k < layout.gaps; ++k)
      openings.push_back({layout.from(k), layout.from(k) + c.gap, part.bottom, part.top});
  }
  if (c.post_depth && *c.post_depth < dam.thickness)
    openings.push_back({layout.first, end, sill.bottom, infinity, *c.post_depth});
}

}  // namespace

GridLayout grid_layout(const GridCase& grid) {
  GridLayout layout;
  layout.pitch = grid.gap + grid.post_width;
  const double whole = grid.to - grid.from;
  const double fitting = (whole + grid.post_width) / layout.pitch + 1e-9;
  layout.gaps = static_cast<int>(std::clamp(fitting, 1.0, 1e9));
  const double taken = layout.gaps * layout.pitch - grid.post_width;
  layout.first = grid.from + (whole - taken) / 2;
  return layout;
}

std::vector<Opening> dam_openings(const StructureCase& c, const CheckDam& dam,
                                  const Surface& surface, const std::string& key) {
  std::vector<Opening> openings;
  for (std::size_t k = 0; k < c.slits.size(); ++k)
    openings.push_back(
        slit_opening(c.slits[k], dam, surface, fmt::format("{}.slit[{}]", key, k + 1)));
  for (std::size_t k = 0; k < c.grids.size(); ++k)
    add_grid(c.grids[k], dam, surface, fmt::format("{}.grid[{}]", key, k + 1), openings);
  return openings;
}

}  // namespace sabo
