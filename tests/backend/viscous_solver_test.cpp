#include "backend/viscous_solver.hpp"

#include <array>

#include <gtest/gtest.h>

namespace sabo {
namespace {

// A = (4 -1 0; -1 3 -1; 0 -1 2): with b = (2, 2, 4) x = (1, 2, 3); with b = (3, 1, 1) x = (1, 1,
// 1).
constexpr double matrix[3][3] = {{4, -1, 0}, {-1, 3, -1}, {0, -1, 2}};

struct Problem {
  ViscousSolver<double> solver;
  std::vector<double> mass{1, 1, 1, 1};
  std::vector<std::uint32_t> rows{0, 1, 2};
  HostExecutor on;
  int products = 0, needless = 0;

  Problem() {
    solver.reset(on, 4);  // the fourth takes no part
    solver.diagonal = {4, 3, 2, 1};
  }

  ViscousSolve solve(double tolerance, int most) {
    const auto multiply = [this](const SolveProgress<double>* progress) {
      ++(progress->has_ended ? needless : products);
      if (progress->has_ended) return;
      Total sum;
      for (int i = 0; i < 3; ++i) {
        Quad<double> q{};
        for (int j = 0; j < 3; ++j) {
          const Quad<double>& p = solver.direction[j];
          q = {q.x + matrix[i][j] * p.x, q.y + matrix[i][j] * p.y, q.z + matrix[i][j] * p.z};
        }
        solver.product[i] = q;
        const Quad<double>& p = solver.direction[i];
        sum.join({p.x * q.x + p.y * q.y + p.z * q.z});
      }
      solver.curvature[0] = sum;
    };
    const auto residual_of = [](std::size_t i) {
      return std::array<Quad<double>, 4>{{{2, 3, 0}, {2, 1, 0}, {4, 1, 0}, {9, 9, 9}}}[i];
    };
    return solver.solve(
        on, {rows.data(), 3}, mass.data(), residual_of, [tolerance] { return tolerance; }, most,
        multiply);
  }
};

// Conjugate gradients are exact after as many steps as the matrix has eigenvalues.
TEST(ViscousSolver, SolvesThreeComponentsInAsManyStepsAsEigenvalues) {
  Problem problem;
  const ViscousSolve outcome = problem.solve(1e-12, 10);
  EXPECT_TRUE(outcome.converged);
  EXPECT_LE(outcome.iterations, 3);
  const double x[3][3] = {{1, 1, 0}, {2, 1, 0}, {3, 1, 0}};
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(problem.solver.change[i].x, x[i][0], 1e-12);
    EXPECT_NEAR(problem.solver.change[i].y, x[i][1], 1e-12);
    EXPECT_EQ(problem.solver.change[i].z, 0);
  }
  EXPECT_EQ(problem.solver.change[3].x, 0);
}

// A flow from rest without gravity has no scale of its own to measure a tolerance by.
TEST(ViscousSolver, EndsWhereOnlyRoundingIsLeft) {
  Problem problem;
  const ViscousSolve outcome = problem.solve(0, 10);
  EXPECT_TRUE(outcome.converged);
  EXPECT_GE(outcome.iterations, 3);
  EXPECT_NEAR(problem.solver.change[2].x, 3, 1e-12);
}

TEST(ViscousSolver, SaysThatItDidNotConverge) {
  Problem problem;
  const ViscousSolve outcome = problem.solve(1e-12, 1);
  EXPECT_FALSE(outcome.converged);
  EXPECT_EQ(outcome.iterations, 1);
}

// The root mean square of b over the mass is sqrt((4 + 4 + 16) / 3) = 2.83 at a change of zero.
TEST(ViscousSolver, DoesNothingWhereTheGuessIsGoodEnough) {
  Problem problem;
  EXPECT_EQ(problem.solve(2.84, 10).iterations, 0);
  EXPECT_GT(Problem().solve(2.82, 10).iterations, 0);
}

// One that runs ahead takes the same iterations to the same bits, whether the last solve took more
// or fewer; what it starts in vain changes nothing.
TEST(ViscousSolver, MayRunAhead) {
  for (const double tolerance : {1e-12, 0.5, 2.84}) {
    Problem waiting, ahead;
    ahead.solver.runs_ahead = true;
    for (const double former : {1e-12, 2.84}) {
      ahead.solve(former, 10);
      ahead.products = 0;
      const ViscousSolve expected = waiting.solve(tolerance, 10),
                         found = ahead.solve(tolerance, 10);
      EXPECT_EQ(found.iterations, expected.iterations);
      EXPECT_EQ(found.converged, expected.converged);
      EXPECT_EQ(ahead.products, expected.iterations);
      for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(ahead.solver.change[i].x, waiting.solver.change[i].x);
        EXPECT_EQ(ahead.solver.change[i].y, waiting.solver.change[i].y);
      }
      EXPECT_EQ(ahead.solver.residual_sum.x, waiting.solver.residual_sum.x);
    }
    EXPECT_GT(ahead.needless, 0);
    EXPECT_EQ(waiting.needless, 0);
  }
}

TEST(ViscousSolver, ThatRunsAheadEndsWithItsLimit) {
  Problem problem;
  problem.solver.runs_ahead = true;
  problem.solve(1e-12, 10);
  problem.products = problem.needless = 0;
  const ViscousSolve outcome = problem.solve(1e-12, 1);
  EXPECT_FALSE(outcome.converged);
  EXPECT_EQ(outcome.iterations, 1);
  EXPECT_EQ(problem.products, 1);
  EXPECT_GT(problem.needless, 0);
  Problem waiting;
  waiting.solve(1e-12, 1);
  EXPECT_EQ(problem.solver.change[2].x, waiting.solver.change[2].x);
}

}  // namespace
}  // namespace sabo
