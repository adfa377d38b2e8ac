// The tables that were retyped from the release of SPHERIC, against the file itself.

#include "verify/cases/spheric2_measured.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>

#include "support/folders.hpp"
#include <gtest/gtest.h>

namespace sabo::spheric2_measured {
namespace {

constexpr int p1_column = 1, p3_column = 3, h1_column = 9, h2_column = 10, h3_column = 11,
              h4_column = 12;

class Measured : public testing::Test {
 protected:
  void SetUp() override {
    std::ifstream file(data_folder() / "validation/kleefsman_spheric2/test_case_2_exp_data.dat");
    if (!file) GTEST_SKIP() << "no data: set SABO_DATA";
    std::string line;
    std::getline(file, line);  // names of the columns
    while (std::getline(file, line)) {
      std::istringstream numbers(line);
      std::array<double, 13> row{};
      for (double& number : row) numbers >> number;
      if (numbers) rows_.push_back(row);
    }
    ASSERT_EQ(rows_.size(), 7395u);
  }

  /// The mean of a column over a window (s) around a time.
  double mean(int column, double time, double window) const {
    double sum = 0;
    int count = 0;
    for (const auto& row : rows_)
      if (std::abs(row[0] - time) <= window / 2) sum += row[column], ++count;
    return sum / count;
  }

  double greatest_mean(int column, double window) const {
    double most = 0;
    for (double time = 0.3; time < 0.8; time += 1e-3)
      most = std::max(most, mean(column, time, window));
    return most;
  }

  double integral(int column, double from, double to) const {
    double sum = 0;
    for (std::size_t k = 1; k < rows_.size(); ++k)
      if (rows_[k][0] > from && rows_[k][0] <= to)
        sum += rows_[k][column] * (rows_[k][0] - rows_[k - 1][0]);
    return sum;
  }

  std::vector<std::array<double, 13>> rows_;
};

TEST_F(Measured, PressuresAreMeansOfTheSamples) {
  constexpr double one_sample = 5000 / 20.0;  // Pa, in or out of the window while P1 rises
  for (std::size_t k = 0; k < measured_p1.size(); ++k) {
    const double time = pressure_start + pressure_step * static_cast<double>(k);
    EXPECT_NEAR(measured_p1[k], mean(p1_column, time, 0.02), one_sample) << time;
    EXPECT_NEAR(measured_p3[k], mean(p3_column, time, 0.02), one_sample) << time;
  }
}

TEST_F(Measured, HeightsAreMeansOfTheSamples) {
  for (std::size_t k = 0; k < measured_h2.size(); ++k) {
    const double time = height_step * static_cast<double>(k);
    EXPECT_NEAR(measured_h1[k], mean(h1_column, time, 0.05), 0.002) << time;
    EXPECT_NEAR(measured_h2[k], mean(h2_column, time, 0.05), 0.002) << time;
    EXPECT_NEAR(measured_h3[k], mean(h3_column, time, 0.05), 0.002) << time;
    EXPECT_NEAR(measured_h4[k], mean(h4_column, time, 0.05), 0.002) << time;
  }
}

TEST_F(Measured, PeaksArrivalAndImpulsesAreThoseOfTheSamples) {
  double highest = 0;
  for (const auto& row : rows_) highest = std::max(highest, row[p1_column]);
  EXPECT_NEAR(p1_quarter, highest / 4, 5);
  const auto first =
      std::ranges::find_if(rows_, [](const auto& row) { return row[p1_column] > p1_quarter; });
  EXPECT_NEAR(p1_arrival, (*first)[0], 0.002);
  EXPECT_NEAR(p1_peak, greatest_mean(p1_column, 0.02), 0.01 * p1_peak);
  EXPECT_NEAR(p3_peak, greatest_mean(p3_column, 0.02), 0.01 * p3_peak);
  EXPECT_NEAR(p1_impulse, integral(p1_column, 0.4, 1), 0.005 * p1_impulse);
  EXPECT_NEAR(p3_impulse, integral(p3_column, 0.4, 1), 0.005 * p3_impulse);
  for (std::size_t k = 0; k < face_means.size(); ++k)
    EXPECT_NEAR(face_means[k], mean(p1_column + k, 0.75, 0.5), 0.005 * face_means[k]);
}

}  // namespace
}  // namespace sabo::spheric2_measured
