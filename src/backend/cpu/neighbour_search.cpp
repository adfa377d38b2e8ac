#include "backend/cpu/neighbour_search.hpp"

#include <algorithm>

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

NeighbourSearch::NeighbourSearch(const Periodic& periodic, double radius, int threads)
    : periodic_(periodic), radius_(radius), threads_(threads) {
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

void NeighbourSearch::append_near(const ColumnGrid& grid, const std::vector<Vec3d>& cloud,
                                  const Vec3d& x, std::uint32_t offset, std::uint32_t self,
                                  std::vector<std::uint32_t>& list) const {
  const double radius2 = radius_ * radius_;
  for (const Vec3d& shift : shifts_) {
    const Vec3d image = x + shift;
    grid.for_each_run(cloud, image, radius_, [&](std::uint32_t first, std::uint32_t last) {
      // Three of four candidates are too far, in no order a processor could predict: write each,
      // keep the near ones.
      const std::size_t before = list.size();
      list.resize(before + (last - first));
      std::uint32_t* end = list.data() + before;
      for (std::uint32_t j = first; j < last; ++j) {
        const Vec3d d = image - cloud[j];
        *end = offset + j;
        end += static_cast<int>(dot(d, d) < radius2) & static_cast<int>(offset + j != self);
      }
      list.resize(static_cast<std::size_t>(end - list.data()));
    });
  }
}

void NeighbourSearch::fill(const std::vector<Vec3d>& fluid, const std::vector<Vec3d>& boundary,
                           PairList& list, std::vector<char>& has_neighbours) const {
  const auto fluids = static_cast<std::uint32_t>(fluid.size());
  list.reset(fluid.size() + boundary.size());
  has_neighbours.resize(fluid.size());
  const auto append = [&](std::size_t i, int part, std::vector<std::uint32_t>& neighbours) {
    const bool is_fluid = i < fluids;
    const Vec3d& x = is_fluid ? fluid[i] : boundary[i - fluids];
    const auto self = static_cast<std::uint32_t>(i);
    const std::size_t before = neighbours.size();
    if (part == 0) append_near(fluid_grid_, fluid, x, 0, self, neighbours);
    if (part == 1 && is_fluid) append_near(boundary_grid_, boundary, x, fluids, self, neighbours);
    const bool found = neighbours.size() > before;
    if (is_fluid) has_neighbours[i] = found || (part == 1 && has_neighbours[i]);
  };
#pragma omp parallel for num_threads(threads_) schedule(dynamic, 1)
  for (std::ptrdiff_t c = 0; c < static_cast<std::ptrdiff_t>(list.chunk_count()); ++c)
    list.fill_chunk(c, append);
}

}  // namespace sabo
