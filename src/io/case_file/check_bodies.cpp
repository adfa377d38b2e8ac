#include "io/case_file/check_bodies.hpp"

#include <fmt/format.h>

#include "io/case_file/check_parts.hpp"

namespace sabo {
namespace {

void check_keys(const BodyCase& body, const std::string& path, Faults& faults) {
  const BodyCase plain;
  const bool is_mesh = body.kind == BodyKind::mesh;
  const KeyRule rules[] = {
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
  check_keys(rules, word_of(body.kind), path, faults);
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
