#include "backend/cpu/neighbour_search.hpp"

#include <algorithm>

#include "base/host_loops.hpp"

namespace sabo {

void bounding_box(std::initializer_list<const std::vector<Vec3d>*> clouds, Vec3d& low,
                  Vec3d& high) {
  bool is_first = true;
  low = high = {};
  for (const std::vector<Vec3d>* cloud : clouds) {
    for (const Vec3d& x : *cloud) {
      if (is_first) low = high = x;
      is_first = false;
      low = {std::min(low.x, x.x), std::min(low.y, x.y), std::min(low.z, x.z)};
      high = {std::max(high.x, x.x), std::max(high.y, x.y), std::max(high.z, x.z)};
    }
  }
}

NeighbourSearch::NeighbourSearch(const Periodic& periodic, double radius, int threads,
                                 const PairSweeps& sweeps)
    : periodic_(periodic), radius_(radius), threads_(threads), sweeps_(sweeps) {
  const auto reach = [&](int axis) { return periodic_.on(axis) ? 1 : 0; };
  for (int a = -reach(0); a <= reach(0); ++a)
    for (int b = -reach(1); b <= reach(1); ++b)
      for (int c = -reach(2); c <= reach(2); ++c)
        shifts_.push_back(double(a) * periodic_.period[0] + double(b) * periodic_.period[1] +
                          double(c) * periodic_.period[2]);
}

void NeighbourSearch::sort(Particles& fluid, Particles& boundary) {
  const auto sorted = [&](Particles& particles) {
    Vec3d low, high;
    bounding_box({&particles.position}, low, high);
    ColumnGrid grid(low, high, radius_);
    particles.permute(grid.sorted_order(particles.position, particles.id, threads_));
    return grid;
  };
  fluid_grid_ = sorted(fluid);
  boundary_grid_ = sorted(boundary);
}

NeighbourSearch::Points::Points(const std::vector<Vec3d>& positions, const Vec3d& centre,
                                int threads)
    : x(positions.size() + PairList::lanes), y(x.size()), z(x.size()) {
  over(positions.size(), threads, [&](std::size_t i) {
    const Vec3d d = positions[i] - centre;
    x[i] = float(d.x);
    y[i] = float(d.y);
    z[i] = float(d.z);
  });
}

std::vector<ColumnGrid::Runs> NeighbourSearch::start(const Cloud& cloud) const {
  return {shifts_.size(), ColumnGrid::Runs(cloud.grid, cloud.positions, radius_)};
}

std::size_t NeighbourSearch::append_near(const Cloud& cloud, std::vector<ColumnGrid::Runs>& runs,
                                         const Vec3d& centre, const Vec3d& x, std::uint32_t self,
                                         PairList::Chunk& list) const {
  const Points& p = cloud.points;
  std::size_t found = 0;
  for (std::size_t k = 0; k < shifts_.size(); ++k) {
    const Vec3d image = x + shifts_[k];
    const Vec3d place = image - centre;
    runs[k].move_to(image);
    const std::size_t count = sweeps_.near_search(
        {p.x.data(), p.y.data(), p.z.data(), runs[k].runs(), runs[k].count(), float(place.x),
         float(place.y), float(place.z), float(radius_ * radius_), cloud.offset, self,
         list.room(runs[k].size())});
    list.advance(count);
    found += count;
  }
  return found;
}

void NeighbourSearch::fill(const std::vector<Vec3d>& fluid, const std::vector<Vec3d>& boundary,
                           PairList& list, std::vector<char>& has_neighbours) const {
  const auto fluids = static_cast<std::uint32_t>(fluid.size());
  Vec3d low, high;
  bounding_box({&fluid, &boundary}, low, high);
  const Vec3d centre = 0.5 * (low + high);
  const Cloud flow{fluid_grid_, fluid, {fluid, centre, threads_}, 0};
  const Cloud walls{boundary_grid_, boundary, {boundary, centre, threads_}, fluids};
  list.reset(fluid.size() + boundary.size());
  has_neighbours.resize(fluid.size());
#pragma omp parallel for num_threads(threads_) schedule(dynamic, 1)
  for (std::ptrdiff_t c = 0; c < static_cast<std::ptrdiff_t>(list.chunk_count()); ++c) {
    auto flow_runs = start(flow);
    auto wall_runs = start(walls);
    list.fill_chunk(c, [&](std::size_t i, int part, PairList::Chunk& chunk) {
      const bool is_fluid = i < fluids;
      const Vec3d& x = is_fluid ? fluid[i] : boundary[i - fluids];
      const auto self = static_cast<std::uint32_t>(i);
      std::size_t found = 0;
      if (part == 0) found = append_near(flow, flow_runs, centre, x, self, chunk);
      if (part == 1 && is_fluid) found = append_near(walls, wall_runs, centre, x, self, chunk);
      if (is_fluid) has_neighbours[i] = found > 0 || (part == 1 && has_neighbours[i]);
    });
  }
}

}  // namespace sabo
