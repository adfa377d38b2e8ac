#include "io/case_file/check_bodies.hpp"

#include <fmt/format.h>

namespace sabo {
namespace {

/// A key, whether it is given, and whether the kind of body has it and needs it.
struct Rule {
  const char* key;
  bool is_given;
  bool applies;
  bool is_needed = false;
  const char* remedy = "give it";
};

void check_keys(const BodyCase& body, const std::string& path, Faults& faults) {
  const BodyCase plain;
  const bool is_mesh = body.kind == BodyKind::mesh;
  const Rule rules[] = {
      {"min", body.min.has_value(), !is_mesh, true, "give its lowest corner [x, y, z]"},
      {"max", body.max.has_value(), !is_mesh, true, "give the corner across [x, y, z]"},
      {"rotation", body.rotation != plain.rotation, !is_mesh},
      {"open_top", body.open_top != plain.open_top, body.kind == BodyKind::tank},
      {"file", !body.file.empty(), is_mesh, true, "give an STL or OBJ file"},
      {"frame", body.frame != plain.frame, is_mesh},
      {"at", body.at.has_value(), is_mesh, body.frame == BodyFrame::local,
       "give the place of its origin [x, y, z]"},
      {"scale", body.scale != plain.scale, is_mesh},
      {"flow", body.flow != plain.flow, is_mesh}};
  for (const Rule& rule : rules) {
    const std::string key = fmt::format("{}.{}", path, rule.key);
    if (faults.has(key)) continue;
    if (rule.is_given && !rule.applies) {
      faults.add(key, fmt::format("does not apply to kind \"{}\"", word_of(body.kind)),
                 "remove it");
    } else if (!rule.is_given && rule.applies && rule.is_needed) {
      faults.add(key, "is missing", rule.remedy);
    }
  }
}

void check_corners(const BodyCase& body, const std::string& path, Faults& faults) {
  if (body.kind == BodyKind::mesh || !body.min || !body.max) return;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if ((*body.min)[axis] < (*body.max)[axis]) continue;
    faults.add(path + ".max", fmt::format("its {} is not above that of min", "xyz"[axis]),
               "give corners across from each other, the lower one as min");
    return;
  }
}

}  // namespace

void check_bodies(const std::vector<BodyCase>& bodies, Faults& faults) {
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const std::string path = fmt::format("body[{}]", k + 1);
    if (faults.has(path + ".kind")) continue;
    check_keys(bodies[k], path, faults);
    check_corners(bodies[k], path, faults);
  }
}

}  // namespace sabo
