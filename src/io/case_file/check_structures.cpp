#include "io/case_file/check_structures.hpp"

#include <fmt/format.h>

#include "io/case_file/check_parts.hpp"
#include "io/case_file/key_text.hpp"

namespace sabo {
namespace {

void check_keys(const StructureCase& structure, const std::string& path, Faults& faults) {
  const bool is_dam = structure.kind == StructureKind::check_dam;
  const bool is_building = structure.kind == StructureKind::building;
  const bool has_file = !structure.polygon.file.empty();
  const KeyRule rules[] = {
      {"line", structure.line.given(), !is_building, true, "give a vector file or coordinates"},
      {"polygon", structure.polygon.given(), is_building, true,
       "give a vector file or coordinates"},
      {"crest", structure.crest.has_value(), !is_building},
      {"height_attribute", !structure.height_attribute.empty(), is_building},
      {"thickness", structure.thickness.has_value(), !is_building, true, "give it, in m"},
      {"notch", structure.notch.has_value(), is_dam},
      {"slit", !structure.slits.empty(), is_dam},
      {"grid", !structure.grids.empty(), is_dam}};
  check_keys(rules, word_of(structure.kind), path, faults);
  const std::string attribute = path + ".height_attribute";
  if (is_building && !structure.height_attribute.empty() && structure.polygon.given() &&
      !has_file && !faults.has(attribute)) {
    faults.add(attribute, "a polygon given by coordinates has no attributes", "give height");
  }
}

void check_crest(const StructureCase& dam, const std::string& path, Faults& faults) {
  const bool crest = dam.crest || faults.has(path + ".crest");
  const bool height = dam.height || faults.has(path + ".height");
  if (crest && height) {
    faults.add(path, "has a crest and a height", "give one of the two");
  } else if (dam.line.has_z && (crest || height)) {
    faults.add(path + (crest ? ".crest" : ".height"), "the z of the line is the crest already",
               "remove one of the two");
  } else if (!dam.line.coordinates.empty() && !dam.line.has_z && !crest && !height) {
    faults.add(path, "has no crest", "give crest, height, or a line with z");
  }
}

void check_building_height(const StructureCase& building, const std::string& path, Faults& faults) {
  const bool height = building.height || faults.has(path + ".height");
  const bool attribute =
      !building.height_attribute.empty() || faults.has(path + ".height_attribute");
  if (height && attribute) {
    faults.add(path, "has a height and a height_attribute", "give one of the two");
  } else if (!height && !attribute) {
    faults.add(path, "has no height", "give height or height_attribute");
  }
}

/// A piece of the line that an opening takes.
struct Stretch {
  double from;
  double to;
  std::string key;  ///< to report it at
};

/// `key` is the one that says where the stretch lies.
void check_within(const Stretch& stretch, const LineSource& line, Faults& faults) {
  const double length = plan_length(line);
  const double rounding = 1e-6 * (1 + length);
  if (faults.has(stretch.key)) return;
  if (stretch.from < -rounding) {
    faults.add(stretch.key, "reaches beyond the start of the line", "move it, or make it narrower");
  } else if (length > 0 && stretch.to > length + rounding) {
    faults.add(stretch.key, "reaches beyond the end of the line",
               fmt::format("give distances along the line, at most {} m", short_text(length)));
  }
}

void check_sill(const SillCase& sill, const std::string& path, Faults& faults) {
  const bool by_height = sill.height || faults.has(path + ".sill");
  const bool by_elevation = sill.elevation || faults.has(path + ".sill_elevation");
  if (by_height && by_elevation)
    faults.add(path, "has a sill and a sill_elevation", "give one of the two");
}

/// Openings above the crest leave the dam as it is.
void check_below_crest(const SillCase& sill, const StructureCase& dam, const std::string& path,
                       Faults& faults) {
  if (dam.height && sill.height && *sill.height >= *dam.height && !faults.has(path + ".sill")) {
    faults.add(path + ".sill", "is not below the crest",
               fmt::format("give less than {} m", short_text(*dam.height)));
  }
  if (dam.crest && sill.elevation && *sill.elevation >= *dam.crest &&
      !faults.has(path + ".sill_elevation")) {
    faults.add(path + ".sill_elevation", "is not below the crest",
               fmt::format("give less than {} m", short_text(*dam.crest)));
  }
}

void check_notch(const StructureCase& dam, const std::string& path, Faults& faults) {
  if (!dam.notch) return;
  if (dam.height && dam.notch->depth > *dam.height) {
    faults.add(path + ".notch.depth", "the notch is deeper than the dam is high",
               fmt::format("give at most {} m", short_text(*dam.height)));
  }
  const double length = plan_length(dam.line);
  if (length > 0 && dam.notch->centre > length) {
    faults.add(path + ".notch.centre", "lies beyond the end of the line",
               fmt::format("give a distance along the line, at most {} m", short_text(length)));
  }
  if (length > 0 && dam.notch->width > length) {
    faults.add(path + ".notch.width", "the notch is wider than the dam is long",
               fmt::format("give at most {} m", short_text(length)));
  }
}

void check_grid(const GridCase& grid, const StructureCase& dam, const std::string& path,
                Faults& faults) {
  if (!(grid.from < grid.to) && !faults.has(path + ".from") && !faults.has(path + ".to")) {
    faults.add(path + ".to", "is not beyond from", "give a stretch of some length");
    return;
  }
  const double two_gaps = 2 * grid.gap + grid.post_width;
  if (grid.gap > 0 && grid.post_width > 0 && grid.to - grid.from < two_gaps * (1 - 1e-9)) {
    faults.add(path,
               fmt::format("is {} m long, which has no room for a post and a gap on each "
                           "side of it",
                           short_text(grid.to - grid.from)),
               fmt::format("give {} m or more, or a slit", short_text(two_gaps)));
  }
  if (grid.post_depth && dam.thickness && *grid.post_depth > *dam.thickness) {
    faults.add(path + ".post_depth", "is more than the thickness of the dam",
               fmt::format("give at most {} m", short_text(*dam.thickness)));
  }
  if (grid.beam_gap.has_value() != grid.beam_height.has_value() &&
      !faults.has(path + ".beam_gap") && !faults.has(path + ".beam_height")) {
    faults.add(path + (grid.beam_gap ? ".beam_gap" : ".beam_height"), "is one of a pair",
               grid.beam_gap ? "give beam_height too" : "give beam_gap too");
  }
}

void check_openings(const StructureCase& dam, const std::string& path, Faults& faults) {
  check_notch(dam, path, faults);
  for (std::size_t k = 0; k < dam.slits.size(); ++k) {
    const SlitCase& slit = dam.slits[k];
    const std::string key = fmt::format("{}.slit[{}]", path, k + 1);
    check_sill(slit.sill, key, faults);
    check_below_crest(slit.sill, dam, key, faults);
    check_within({slit.centre - slit.width / 2, slit.centre + slit.width / 2, key + ".centre"},
                 dam.line, faults);
  }
  for (std::size_t k = 0; k < dam.grids.size(); ++k) {
    const GridCase& grid = dam.grids[k];
    const std::string key = fmt::format("{}.grid[{}]", path, k + 1);
    check_sill(grid.sill, key, faults);
    check_below_crest(grid.sill, dam, key, faults);
    check_within({grid.from, grid.to, key + ".to"}, dam.line, faults);
    check_grid(grid, dam, key, faults);
  }
}

}  // namespace

void check_structures(const std::vector<StructureCase>& structures, Faults& faults) {
  for (std::size_t k = 0; k < structures.size(); ++k) {
    const StructureCase& structure = structures[k];
    const std::string path = fmt::format("structure[{}]", k + 1);
    check_line(structure.line, path + ".line", faults);
    check_polygon(structure.polygon, path + ".polygon", faults);
    if (faults.has(path + ".kind")) continue;
    check_keys(structure, path, faults);
    if (structure.kind == StructureKind::building) {
      check_building_height(structure, path, faults);
      continue;
    }
    check_crest(structure, path, faults);
    if (structure.kind == StructureKind::check_dam) check_openings(structure, path, faults);
  }
}

}  // namespace sabo
