#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include "support/folders.hpp"
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "physics/rheology_list.hpp"
#include "physics/yield.hpp"

// Expected values stand in tests/physics/rheology/NAME.csv, one file a law: its keys, the place
// (shear rate 1/s, yield stress Pa, effective pressure Pa), the viscosity (Pa s), how it is
// derived.

namespace sabo {
namespace {

using Row = std::map<std::string, std::string>;

std::vector<std::string> split(const std::string& line, std::size_t columns) {
  std::vector<std::string> cells;
  std::istringstream text(line);
  for (std::string cell; cells.size() + 1 < columns && std::getline(text, cell, ',');)
    cells.push_back(cell);
  std::string rest;  // the last column is prose and may have commas
  std::getline(text, rest);
  cells.push_back(rest);
  return cells;
}

std::vector<Row> table_of(std::string_view law) {
  const auto file = repository() / "tests" / "physics" / "rheology" / (std::string(law) + ".csv");
  std::ifstream stream(file);
  EXPECT_TRUE(stream) << "no table of values " << file;
  std::vector<std::string> header;
  std::vector<Row> rows;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with('#')) continue;
    if (header.empty()) {
      header = split(line, 100);
      header.pop_back();  // the empty rest of the line
      continue;
    }
    const std::vector<std::string> cells = split(line, header.size());
    EXPECT_EQ(cells.size(), header.size()) << file << ": " << line;
    for (Row& row = rows.emplace_back(); const std::string& name : header)
      row[name] = cells[row.size()];
  }
  return rows;
}

double number(const std::string& text) {
  double value = std::nan("");
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// Visitor that sets every key of a law from the row, and fails when the row lacks one.
struct KeySetter {
  const Row& row;
  void operator()(const Key& key, double& member) const {
    const auto cell = row.find(std::string(key.name));
    ASSERT_NE(cell, row.end()) << key.name;
    member = number(cell->second);
    EXPECT_TRUE(key.accepts(member)) << key.name << " = " << member;
  }
};

TEST(Rheology, EveryLawMatchesItsTable) {
  for (Rheology law : all_rheologies()) {
    const std::vector<Row> rows = table_of(name_of(law));
    EXPECT_GE(rows.size(), 3u) << name_of(law);
    for (const Row& row : rows) {
      const Shear at{number(row.at("shear_rate")), number(row.at("yield_stress")),
                     number(row.at("pressure"))};
      const double expected = number(row.at("expected"));
      std::visit(
          [&](auto& l) {
            l.describe(KeySetter{row});
            EXPECT_NEAR(l.viscosity(at), expected, 1e-12 * expected)
                << l.name << ": " << row.at("derivation");
          },
          law);
    }
  }
}

TEST(Rheology, EveryLawHasAPage) {
  for (const Rheology& law : all_rheologies()) {
    const auto page = repository() / "docs" / "rheology" / (std::string(name_of(law)) + ".md");
    EXPECT_TRUE(std::filesystem::exists(page)) << page;
  }
}

/// 1e-8 to 1e4, the twelve decades a flow can show.
rc::Gen<double> shear_rates() {
  return rc::gen::map(rc::gen::inRange(-8000, 4000), [](int k) { return std::pow(10, k / 1e3); });
}

RC_GTEST_PROP(Rheology, StressNeverFallsWithShearRateAndViscosityStaysInBounds, ()) {
  const double gd = *shear_rates();
  const double yield_stress = *rc::gen::element(0.0, 1e-300, 1e-6, 50.0, 1e6);
  const double pressure = *rc::gen::element(0.0, 1e-300, 1e-6, 100.0, 1e6);
  for (const Rheology& law : all_rheologies()) {
    std::visit(
        [&](const auto& l) {
          const double mu = l.viscosity(Shear{gd, yield_stress, pressure});
          RC_ASSERT(std::isfinite(mu));
          RC_ASSERT(mu > 0);
          RC_ASSERT(mu <= l.max_viscosity() * (1 + 1e-12));
          const double faster = 1.01 * gd;
          const double stress = l.viscosity(Shear{faster, yield_stress, pressure}) * faster;
          RC_ASSERT(stress >= mu * gd * (1 - 1e-14));
        },
        law);
  }
}

RC_GTEST_PROP(Rheology, NoLawBreaksAtRest, ()) {
  const double yield_stress = *rc::gen::element(0.0, 1e-300, 50.0, 1e9);
  const double pressure = *rc::gen::element(0.0, 1e-300, 100.0, 1e9);
  for (const Rheology& law : all_rheologies()) {
    std::visit(
        [&](const auto& l) {
          const double mu = l.viscosity(Shear{0, yield_stress, pressure});
          RC_ASSERT(std::isfinite(mu));
          RC_ASSERT(mu > 0);
          RC_ASSERT(mu <= l.max_viscosity());
        },
        law);
  }
}

/// Far above the rates of regularisation each law of Bingham's family carries the Bingham stress;
/// the Cross fluid lacks the share mu_inf/mu_0 of tau_B (Eq. 22 multiplied out).
TEST(Rheology, FastFlowHasTheBinghamStress) {
  constexpr double gd = 1e3;
  const Shear at{gd, 50, 0};
  const double bingham = 20 * gd + 50;
  EXPECT_DOUBLE_EQ((Bingham{{20, 1000}}.viscosity(at) * gd), bingham);
  EXPECT_DOUBLE_EQ((Threshold{{20, 1000}, 0.01}.viscosity(at) * gd), bingham);
  EXPECT_DOUBLE_EQ((Papanastasiou{{20, 1000}, 100}.viscosity(at) * gd), bingham);
  EXPECT_DOUBLE_EQ((Quadratic{{20, 1000}, 0}.viscosity(at) * gd), bingham);
  EXPECT_NEAR((FrigaardNouar{{20, 1000}, 0.01}.viscosity(at) * gd), bingham, 50 * 0.01 / gd);
  EXPECT_NEAR((Cross{20, 1000, 1}.viscosity(at) * gd), bingham - 0.05, 1e-3);
}

/// With a tight regularisation the stress of slow flow is the yield stress: no law loses or adds
/// strength.
TEST(Rheology, SlowFlowHasTheYieldStress) {
  const Rheology laws[] = {Cross{20, 1e6, 1},
                           Bingham{{20, 1e6}},
                           FrigaardNouar{{20, 1e6}, 1e-9},
                           Threshold{{20, 1e6}, 1e-9},
                           Papanastasiou{{20, 1e6}, 1e9},
                           HerschelBulkley{1, 0.5, 1e9, 1e9},
                           Quadratic{{20, 1e6}, 1},
                           MuI{0.26, 0.279, 0.01, 2650, 1, 1e9}};
  constexpr double gd = 0.01;
  constexpr double yield_stress = 50;
  for (const Rheology& law : laws) {
    const double mu = std::visit(
        [](const auto& l) {
          return l.viscosity(Shear{gd, yield_stress, 0});
        },
        law);
    EXPECT_NEAR(mu * gd, yield_stress, 0.01 * yield_stress) << name_of(law);
  }
}

}  // namespace
}  // namespace sabo
