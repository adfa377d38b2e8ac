#pragma once

#include <string>

namespace sabo {

/// A channel of 2 m between walls on a plane of 3 deg.
inline const std::string channel = R"(
[terrain.plane]
extent = [0, 0, 11, 5]
slope = 3
cell_size = 0.5
[[body]]
kind = "box"
min = [-1, 0, -1]
max = [12, 1.5, 3]
[[body]]
kind = "box"
min = [-1, 3.5, -1]
max = [12, 5, 3]
[material]
density = 1000
rheology = "newtonian"
viscosity = 0.1
)";

/// To be followed by its discharge.
inline const std::string inflow = "[[inflow]]\nname = \"apex\"\nline = [[1, 1.5], [1, 3.5]]\n";
/// 1 m deep.
inline const std::string steady =
    "speed = 2.5\n[[inflow.surge]]\nstart = 0\npeak_time = 0\nend = 1e6\n"
    "peak_discharge = 5\n";

}  // namespace sabo
