#include "terrain/ground.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "base/error.hpp"
#include "base/host_loops.hpp"
#include "terrain/body_points.hpp"

namespace sabo {
namespace {

constexpr int tile_columns = 8;      // per side
constexpr double foot_height = 0.5;  // spacings, over which nothing flows under what stands there

/// Both tile numbers in one key; keys sort by column of tiles, then row.
std::int64_t key_of(std::int32_t i, std::int32_t j) {
  return (static_cast<std::int64_t>(i) << 32) | static_cast<std::uint32_t>(j);
}
std::int32_t column_of(std::int64_t key) { return static_cast<std::int32_t>(key >> 32); }
std::int32_t row_of(std::int64_t key) { return static_cast<std::int32_t>(key & 0xffffffff); }

/// Tiles [first, last] per axis.
struct TileRange {
  std::int32_t west = 0, south = 0, east = -1, north = -1;
  friend bool operator==(const TileRange&, const TileRange&) = default;
};

/// Tile numbers that touch [low, high], kept within 32 bits.
std::pair<std::int32_t, std::int32_t> tiles_between(double low, double high, double tile_size) {
  constexpr double most = 1 << 30;
  return {static_cast<std::int32_t>(std::clamp(std::floor(low / tile_size), -most, most)),
          static_cast<std::int32_t>(std::clamp(std::floor(high / tile_size), -most, most))};
}

TileRange tiles_over(double west, double south, double east, double north, double tile_size) {
  const auto [i_first, i_last] = tiles_between(west, east, tile_size);
  const auto [j_first, j_last] = tiles_between(south, north, tile_size);
  return {i_first, j_first, i_last, j_last};
}

TileRange common(const TileRange& a, const TileRange& b) {
  return {std::max(a.west, b.west), std::max(a.south, b.south), std::min(a.east, b.east),
          std::min(a.north, b.north)};
}

/// Tiles that some particles ask for.
class TileKeys {
 public:
  /// A cheap filter in front of an exact one: most particles ask for the tiles that another one has
  /// just asked for.
  void add(const TileRange& range) {
    const auto hash = static_cast<std::uint32_t>(range.west) * 73856093U ^
                      static_cast<std::uint32_t>(range.south) * 19349663U ^
                      static_cast<std::uint32_t>(range.east - range.west) * 83492791U ^
                      static_cast<std::uint32_t>(range.north - range.south) * 2654435761U;
    TileRange& slot = recent_[hash % recent_.size()];
    if (std::exchange(slot, range) == range) return;
    for (std::int32_t i = range.west; i <= range.east; ++i) {
      for (std::int32_t j = range.south; j <= range.north; ++j) keys_.push_back(key_of(i, j));
    }
  }
  void join(const TileKeys& next) {
    keys_.insert(keys_.end(), next.keys_.begin(), next.keys_.end());
  }
  /// Each key once, sorted.
  std::vector<std::int64_t> take() {
    std::sort(keys_.begin(), keys_.end());
    keys_.erase(std::unique(keys_.begin(), keys_.end()), keys_.end());
    return std::move(keys_);
  }

 private:
  std::array<TileRange, 64> recent_;
  std::vector<std::int64_t> keys_;
};

/// The bounds of a dam in plan.
Bounds bounds_of(const CheckDam& dam) {
  Bounds bounds{dam.axis.vertices.front(), dam.axis.vertices.front()};
  for (const Vec3d& v : dam.axis.vertices) {
    bounds.low = {std::min(bounds.low.x, v.x), std::min(bounds.low.y, v.y), 0};
    bounds.high = {std::max(bounds.high.x, v.x), std::max(bounds.high.y, v.y), 0};
  }
  const Vec3d half{dam.thickness / 2, dam.thickness / 2, 0};
  return {bounds.low - half, bounds.high + half};
}

}  // namespace

Ground::Ground(const Surface& surface, std::vector<CheckDam> dams, const GroundSettings& settings,
               std::vector<Body> bodies)
    : surface_(surface),
      dams_(std::move(dams)),
      bodies_(std::move(bodies)),
      settings_(settings),
      columns_(surface, settings),
      tile_size_(tile_columns * settings.spacing) {
  for (const CheckDam& dam : dams_) bounds_.push_back(bounds_of(dam));
  for (const Body& body : bodies_) bounds_.push_back(body.bounds());
  place_dams();
  for (std::size_t k = 0; k < bodies_.size(); ++k) place_body(k);
}

void Ground::place_dams() {
  std::uint16_t number = 0;
  for (const CheckDam& dam : dams_) {
    ++number;
    for (DamColumn& column : dam_columns(dam, surface_, settings_.spacing)) {
      column.body = number;
      dam_columns_[tile_at(column.x, column.y)].push_back(column);
    }
  }
}

void Ground::place_body(std::size_t index) {
  const Body& body = bodies_[index];
  const auto number = static_cast<std::uint16_t>(dams_.size() + index + 1);
  const auto is_taken = [&](const Vec3d& x) {
    const auto holds_it = [&](const Body& other) { return other.contains(x); };
    return x.z < surface_.height(x.x, x.y) || is_in_dam(x) ||
           std::any_of(bodies_.begin(), bodies_.begin() + static_cast<std::ptrdiff_t>(index),
                       holds_it);
  };
  bool is_seen = false;
  for (GroundPoint& point : body_points(body, settings_.spacing, settings_.density)) {
    const Vec3d& x = point.position;
    if (is_taken(x)) continue;
    is_seen = is_seen || surface_.inside(x.x, x.y);
    point.body = number;
    body_points_[tile_at(x.x, x.y)].push_back(point);
  }
  if (!is_seen) {
    throw CaseError("body " + body.name(), "has no part above the ground inside the terrain",
                    "check its place and its elevation");
  }
}

std::int64_t Ground::tile_at(double x, double y) const {
  const TileRange tile = tiles_over(x, y, x, y, tile_size_);
  return key_of(tile.west, tile.south);
}

BoundaryChange Ground::follow(std::span<const Vec3d> fluid, double reach, int threads) {
  const std::vector<std::int64_t> wanted = tiles_near(fluid, reach, threads);
  BoundaryChange change{drop_tiles_except(wanted), {}};
  std::vector<std::int64_t> fresh;
  std::ranges::copy_if(wanted, std::back_inserter(fresh),
                       [this](std::int64_t key) { return !tiles_.contains(key); });
  std::vector<std::vector<GroundPoint>> made(fresh.size());
  over_few(fresh.size(), host_threads(threads),
           [&](std::size_t k) { make_tile(fresh[k], made[k]); });
  for (std::size_t k = 0; k < fresh.size(); ++k) {
    tiles_[fresh[k]] = {next_id_, static_cast<std::uint32_t>(made[k].size())};
    append(made[k], change.made);
  }
  return change;
}

void Ground::make_all(double west, double south, double east, double north, Particles& into) {
  const auto first = [&](double low) {
    return static_cast<std::int64_t>(std::ceil(low / settings_.spacing - 0.5));
  };
  std::vector<GroundPoint> made;
  for (std::int64_t i = first(west); i < first(east); ++i) {
    for (std::int64_t j = first(south); j < first(north); ++j) columns_.make(i, j, false, made);
  }
  append(made, into);
}

/// Keys of the tiles within reach, sorted.
std::vector<std::int64_t> Ground::tiles_near(std::span<const Vec3d> fluid, double reach,
                                             int threads) const {
  const Grid& grid = surface_.elevation().grid;
  const double margin = columns_.margin();
  const TileRange domain = tiles_over(grid.west - margin, grid.south() - margin,
                                      grid.east() + margin, grid.north + margin, tile_size_);
  return blocked_sum<TileKeys>(
             fluid.size(), host_threads(threads),
             [&](std::size_t k, TileKeys& keys) {
               const Vec3d& p = fluid[k];
               if (!std::isfinite(p.x + p.y)) return;
               keys.add(common(domain, tiles_over(p.x - reach, p.y - reach, p.x + reach,
                                                  p.y + reach, tile_size_)));
             })
      .take();
}

/// Forgets the tiles that are not wanted; returns those that held particles, sorted by id.
std::vector<IdRun> Ground::drop_tiles_except(const std::vector<std::int64_t>& wanted) {
  std::vector<IdRun> dropped;
  for (auto tile = tiles_.begin(); tile != tiles_.end();) {
    if (std::binary_search(wanted.begin(), wanted.end(), tile->first)) {
      ++tile;
      continue;
    }
    if (tile->second.count > 0) dropped.push_back(tile->second);
    tile = tiles_.erase(tile);
  }
  std::sort(dropped.begin(), dropped.end(),
            [](const IdRun& a, const IdRun& b) { return a.first < b.first; });
  return dropped;
}

void Ground::make_tile(std::int64_t key, std::vector<GroundPoint>& into) const {
  const std::int64_t i_first = static_cast<std::int64_t>(column_of(key)) * tile_columns;
  const std::int64_t j_first = static_cast<std::int64_t>(row_of(key)) * tile_columns;
  const std::size_t before = into.size();
  for (std::int64_t i = i_first; i < i_first + tile_columns; ++i) {
    for (std::int64_t j = j_first; j < j_first + tile_columns; ++j) {
      columns_.make(i, j, true, into);
    }
  }
  mark_foundations(column_of(key) * tile_size_, row_of(key) * tile_size_,
                   std::span(into).subspan(before));
  const auto dam = dam_columns_.find(key);
  if (dam != dam_columns_.end())
    for (const DamColumn& column : dam->second) fill_column(column, settings_, into);
  const auto body = body_points_.find(key);
  if (body != body_points_.end()) into.insert(into.end(), body->second.begin(), body->second.end());
}

/// Makes the ground of a tile under structures their foundations.
void Ground::mark_foundations(double west, double south, std::span<GroundPoint> ground) const {
  const auto overlaps = [](const Bounds& a, double w, double s, double e, double n) {
    return a.low.x <= e && w <= a.high.x && a.low.y <= n && s <= a.high.y;
  };
  for (std::size_t k = 0; k < bounds_.size(); ++k) {
    if (!overlaps(bounds_[k], west, south, west + tile_size_, south + tile_size_)) continue;
    const auto mark = static_cast<std::uint16_t>((k + 1) | foundation_mark);
    for (GroundPoint& point : ground) {
      const Vec3d& x = point.position;
      if (point.body == 0 && overlaps(bounds_[k], x.x, x.y, x.x, x.y) && stands_on(k, x.x, x.y))
        point.body = mark;
    }
  }
}

/// Whether a dam or, after the dams, a body holds a place just above the ground.
bool Ground::stands_on(std::size_t structure, double x, double y) const {
  if (!surface_.inside(x, y)) return false;
  const Vec3d foot{x, y, surface_.height(x, y) + foot_height * settings_.spacing};
  return structure < dams_.size() ? dams_[structure].contains(foot)
                                  : bodies_[structure - dams_.size()].contains(foot);
}

/// Adds particles at rest, numbered from the running counter.
void Ground::append(const std::vector<GroundPoint>& points, Particles& into) {
  if (points.size() > std::numeric_limits<std::uint32_t>::max() - next_id_) {
    throw RunError("the boundary particles of this run cannot be numbered with 32 bits");
  }
  const std::size_t before = into.size();
  into.resize(before + points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    into.position[before + k] = points[k].position;
    into.mass[before + k] = points[k].mass;
    into.density[before + k] = settings_.density;
    into.id[before + k] = next_id_++;
    into.body[before + k] = points[k].body;
  }
}

}  // namespace sabo
