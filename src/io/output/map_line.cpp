#include "io/output/map_line.hpp"

#include "io/output/svg.hpp"

namespace sabo {

LineStyle style_of(MapLine::Kind kind) {
  switch (kind) {
    case MapLine::Kind::dam:
      return {"#c1121f", 4, ""};
    case MapLine::Kind::section:
      return {svg_ink, 2, ""};
    case MapLine::Kind::path:
      return {svg_ink, 1.3, " stroke-dasharray=\"7 5\""};
    case MapLine::Kind::edit:
      return {"#b35900", 2, " stroke-dasharray=\"6 3\""};
    case MapLine::Kind::inflow:
      return {"#7b2d8e", 3, ""};
    case MapLine::Kind::zone:
      break;
  }
  return {"#0b5cad", 1.8, " stroke-dasharray=\"2 3\""};
}

}  // namespace sabo
