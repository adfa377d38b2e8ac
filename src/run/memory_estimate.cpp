#include "run/memory_estimate.hpp"

#include <cmath>
#include <numbers>

namespace sabo {
namespace {

constexpr double bytes_of_program = 75e6;   // libraries and their tables
constexpr double bytes_per_cell = 100;      // elevations twice, and the maps
constexpr double bytes_per_particle = 400;  // fields, rates, start of the step, records
constexpr double bytes_of_watch = 150;      // for rest: positions at six times
constexpr double bytes_of_solve = 520;      // walls, rows and vectors of the implicit viscosity
constexpr double bytes_per_neighbour = 5;   // its index, in vectors that are not quite full
constexpr double bytes_per_near_pair = 12;  // of the fast method: index and matrix, the same
constexpr double list_radius_over_kernel = 1.15;
constexpr double late_depth = 1.5;         // particles
constexpr double late_length = 10;         // of the flow, over its width
constexpr double ground_beside_flow = 11;  // spacings across: a list's radius and half a tile each

// Beside a graphics card: fields of the release, of what the host last asked for and of two copies
// for rows and frames with the memory that they come through, numbers of a frame, places at the
// last look and for rest.
constexpr double host_bytes_of_fluid = 900;
constexpr double host_bytes_of_ground = 130;  // fields

// Of the backend cuda (backend/device/device_backend.hpp), by what is allocated; per particle.
constexpr double card_bytes_of_any = 128 + 9;    // fields; numbers of neighbours
constexpr double card_bytes_of_fluid = 32 + 29;  // rates; place at the last list, whether awake
constexpr double card_bytes_of_fast = 412;       // strain, walls, filling, solver, records
constexpr double card_bytes_of_gradient = 36;    // of the whole viscous stress
constexpr double card_bytes_of_shift = 32;
constexpr double card_bytes_of_paper = 256;        // strain, stress, start of the step, records
constexpr double card_bytes_of_ground_fast = 112;  // density rate, records, weights
constexpr double card_bytes_of_ground_paper = 208;
constexpr double card_bytes_of_index = 4;
constexpr double slice_filling = 0.85;  // rows of a slice are as long as its longest
constexpr double card_radius_over_kernel = 1.1;
constexpr double ground_neighbours = 0.2;  // over those of the fluid, for most ground has none

}  // namespace

double expected_boundary(const FlowModel& model, std::size_t particles) {
  const double layers = std::ceil(model.kernel_radius() / model.spacing);
  const double width = std::sqrt(static_cast<double>(particles) / late_depth / late_length);
  return (width + ground_beside_flow) * (late_length * width + ground_beside_flow) * layers;
}

double card_memory(const FlowModel& model, Method method, double fluid, double boundary) {
  const double radius = card_radius_over_kernel * model.kernel_radius() / model.spacing;
  const double neighbours = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
  const double list = neighbours * card_bytes_of_index / slice_filling;
  const bool is_fast = method == Method::fast;
  const double of_fluid = card_bytes_of_any + card_bytes_of_fluid + list +
                          (is_fast ? card_bytes_of_fast : card_bytes_of_paper) +
                          (is_fast && model.whole_viscous_stress ? card_bytes_of_gradient : 0) +
                          (model.particle_shifting > 0 ? card_bytes_of_shift : 0);
  const double of_ground = card_bytes_of_any + ground_neighbours * list +
                           (is_fast ? card_bytes_of_ground_fast : card_bytes_of_ground_paper);
  return fluid * of_fluid + boundary * of_ground;
}

double expected_card_memory(const FlowModel& model, Method method, std::size_t particles) {
  return card_memory(model, method, static_cast<double>(particles),
                     expected_boundary(model, particles));
}

double expected_memory_beside_card(const FlowModel& model, std::size_t particles,
                                   std::size_t dem_cells) {
  return bytes_of_program + bytes_per_cell * static_cast<double>(dem_cells) +
         host_bytes_of_fluid * static_cast<double>(particles) +
         host_bytes_of_ground * expected_boundary(model, particles);
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
