#include "run/memory_estimate.hpp"

#include <cmath>
#include <numbers>

namespace sabo {
namespace {

constexpr double bytes_of_program = 75e6;   // libraries and their tables
constexpr double bytes_per_cell = 100;      // elevations twice, and the maps
constexpr double bytes_per_particle = 400;  // fields, rates, start of the step, records
constexpr double bytes_of_watch = 150;      // for rest: positions at six times
constexpr double bytes_of_solve = 400;      // walls, rows and vectors of the implicit viscosity
constexpr double bytes_per_neighbour = 5;   // its index, in vectors that are not quite full
constexpr double bytes_per_near_pair = 12;  // of the fast method: index and matrix, the same
constexpr double list_radius_over_kernel = 1.15;
constexpr double late_depth = 1.5;         // particles
constexpr double late_length = 10;         // of the flow, over its width
constexpr double ground_beside_flow = 11;  // spacings across: a list's radius and half a tile each

}  // namespace

double expected_boundary(const FlowModel& model, std::size_t particles) {
  const double layers = std::ceil(model.kernel_radius() / model.spacing);
  const double width = std::sqrt(static_cast<double>(particles) / late_depth / late_length);
  return (width + ground_beside_flow) * (late_length * width + ground_beside_flow) * layers;
}

double expected_memory(const FlowModel& model, Method method, std::size_t particles,
                       std::size_t dem_cells) {
  const bool is_fast = method == Method::fast;
  const double radius = list_radius_over_kernel * model.kernel_radius() / model.spacing;
  const double neighbours = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
  const auto fluid = static_cast<double>(particles);
  const double boundary = expected_boundary(model, particles);
  return bytes_of_program + bytes_per_cell * static_cast<double>(dem_cells) +
         (fluid + boundary) * bytes_per_particle + fluid * bytes_of_watch +
         fluid * neighbours * (bytes_per_neighbour + (is_fast ? bytes_per_near_pair : 0)) +
         fluid * (is_fast ? bytes_of_solve : 0);
}

}  // namespace sabo
