#include "verify/drawn_gate.hpp"

#include <algorithm>

#include "support/scenes.hpp"
#include <gtest/gtest.h>

#include "solver/make_backend.hpp"

namespace sabo {
namespace {

std::ptrdiff_t rows_of(Backend& backend, std::uint16_t body) {
  const auto layers = static_cast<std::ptrdiff_t>(backend.model().wall_layers());
  return std::ranges::count(backend.boundary().body, body) / layers;
}

// A gate of ten rows of 0.1 m drawn at 20 m/s2: after 0.2 s its edge is 0.4 m above the floor,
// and four rows are gone; none of the floor or of another body.
TEST(DrawnGate, LosesItsRowsFromTheFloorUp) {
  FlowModel model = test::plain_model(0.1, 30, 1e-3);
  model.dimension = 2;
  const auto backend = make_backend(BackendKind::cpu, model);
  add_block(backend->fluid(), model, {0, 10, 0, 1, 0, 8});
  add_block(backend->boundary(), model, {-3, 20, 0, 1, -3, 0});
  add_box(backend->boundary(), model, {{1.6, 0, 0}, {1.9, 0, 1}}, 1);
  const double end = 1 + 0.1 * model.wall_layers();
  DrawnGate gate(*backend, {{1, 0, 0}, {end, 0, 1}}, 2, 20);
  const std::size_t others = backend->boundary().size() - 10 * model.wall_layers();

  gate.rise_to(0);
  EXPECT_EQ(rows_of(*backend, 2), 10);
  gate.rise_to(0.2);
  EXPECT_EQ(rows_of(*backend, 2), 6);
  gate.rise_to(1);
  EXPECT_EQ(rows_of(*backend, 2), 0);
  EXPECT_EQ(backend->boundary().size(), others);
}

// sqrt(2 H / g) of 0.55 m is 0.335 s.
TEST(DrawnGate, ByAWeightLeavesTheWaterWithinTheTimeOfLauberAndHager) {
  FlowModel model = test::plain_model(0.05, 30, 1e-3);
  model.dimension = 2;
  const auto backend = make_backend(BackendKind::cpu, model);
  add_block(backend->fluid(), model, {0, 20, 0, 1, 0, 11});
  DrawnGate gate(*backend, {{1, 0, 0}, {1 + 0.05 * model.wall_layers(), 0, 0.55}}, 2, 9.81);
  gate.rise_to(0.3);
  EXPECT_GT(rows_of(*backend, 2), 0);
  gate.rise_to(0.335);
  EXPECT_EQ(rows_of(*backend, 2), 0);
}

}  // namespace
}  // namespace sabo
