#include "analysis/footprint_score.hpp"

#include <cmath>

namespace sabo {

FootprintScore footprint_score(const FootprintPair& pair, const std::vector<std::size_t>& cells) {
  const double area = pair.simulated.grid.cell_area();
  FootprintScore score;
  for (const std::size_t cell : cells) {
    switch (pair.at(cell)) {
      case FootprintCell::hit:
        score.hit += area;
        break;
      case FootprintCell::miss:
        score.miss += area;
        break;
      case FootprintCell::false_alarm:
        score.false_alarm += area;
        break;
      case FootprintCell::dry:
        break;
    }
  }
  return score;
}

DepthError depth_error(const FootprintPair& pair, const std::vector<std::size_t>& cells) {
  double count = 0, sum = 0, absolute = 0, squares = 0;
  for (const std::size_t cell : cells) {
    if (pair.at(cell) != FootprintCell::hit) continue;
    const double error = pair.simulated.values[cell] - pair.observed.values[cell];
    ++count;
    sum += error;
    absolute += std::abs(error);
    squares += error * error;
  }
  if (count == 0) return {};
  return {count * pair.simulated.grid.cell_area(), sum / count, absolute / count,
          std::sqrt(squares / count)};
}

}  // namespace sabo
