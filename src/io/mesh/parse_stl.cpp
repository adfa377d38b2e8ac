#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/shown_text.hpp"
#include "io/mesh/mesh_text.hpp"
#include "io/mesh/read_mesh.hpp"

namespace sabo {
namespace {

constexpr std::size_t header_bytes = 84;  // a comment of 80, the number of triangles
constexpr std::size_t triangle_bytes = 50;

std::uint32_t little_endian(std::string_view bytes) {
  std::uint32_t value = 0;
  for (int k = 3; k >= 0; --k) value = value << 8 | static_cast<unsigned char>(bytes[k]);
  return value;
}

std::size_t triangles_of_header(std::string_view bytes) { return little_endian(bytes.substr(80)); }

bool is_binary(std::string_view bytes) {
  return bytes.size() >= header_bytes &&
         bytes.size() == header_bytes + triangle_bytes * triangles_of_header(bytes);
}

/// Whether a word is another in whatever case; `wanted` is in lower case.
bool is(std::string_view word, std::string_view wanted) {
  return std::equal(word.begin(), word.end(), wanted.begin(), wanted.end(), [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == b;
  });
}

void add_triangle(TriangleMesh& mesh) {
  const auto n = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.triangles.push_back({n - 3, n - 2, n - 1});
}

TriangleMesh parse_binary(std::string_view bytes, const std::string& name, const std::string& key) {
  const std::size_t count = triangles_of_header(bytes);
  if (count > max_mesh_triangles) {
    throw CaseError(key, fmt::format("{} has {} triangles", name, count),
                    fmt::format("give at most {}", max_mesh_triangles));
  }
  TriangleMesh mesh;
  mesh.vertices.reserve(3 * count);
  mesh.triangles.reserve(count);
  for (std::size_t t = 0; t < count; ++t) {
    const std::string_view record = bytes.substr(header_bytes + triangle_bytes * t);
    for (int k = 0; k < 3; ++k) {
      const auto number = [&](int axis) {  // behind the normal
        return std::bit_cast<float>(little_endian(record.substr(12 + 12 * k + 4 * axis)));
      };
      const Vec3d vertex{number(0), number(1), number(2)};
      if (!std::isfinite(vertex.x + vertex.y + vertex.z)) {
        throw CaseError(
            key, fmt::format("{}, triangle {}: has a coordinate that is not finite", name, t + 1),
            "write the file again");
      }
      mesh.vertices.push_back(vertex);
    }
    add_triangle(mesh);
  }
  return mesh;
}

/// Reads "facet normal x y z outer loop vertex x y z (three times) endloop endfacet" one after the
/// other; normals are not used.
class AsciiStl {
 public:
  AsciiStl(std::string_view text, const std::string& name, const std::string& key)
      : text_(text), name_(name), key_(key) {}

  TriangleMesh read() {
    for (std::string_view word = text_.word(); !word.empty(); word = text_.word()) {
      if (!is(word, "solid")) refuse("solid", word);
      text_.skip_line();
      for (word = text_.word(); is(word, "facet"); word = text_.word()) read_facet();
      if (!is(word, "endsolid")) refuse("facet or endsolid", word);
      text_.skip_line();
    }
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void refuse(std::string_view wanted, std::string_view word) const {
    throw CaseError(
        key_,
        fmt::format("{}, line {}: {} where \"{}\" is wanted", name_, text_.line(),
                    word.empty() ? "it ends" : fmt::format("\"{}\"", shown_text(word)), wanted),
        "write the file again, or give a binary STL or an OBJ");
  }

  void expect(std::string_view wanted) {
    const std::string_view word = text_.word();
    if (!is(word, wanted)) refuse(wanted, word);
  }

  double read_number() {
    const std::string_view word = text_.word();
    const auto number = number_of(word);
    if (!number) refuse("a number", word);
    return *number;
  }

  void read_facet() {
    if (mesh_.triangles.size() == max_mesh_triangles) {
      throw CaseError(key_, fmt::format("{} has more than {} triangles", name_, max_mesh_triangles),
                      "simplify it");
    }
    expect("normal");
    for (int k = 0; k < 3; ++k) text_.word();
    expect("outer");
    expect("loop");
    for (int k = 0; k < 3; ++k) {
      expect("vertex");
      const double x = read_number(), y = read_number(), z = read_number();
      mesh_.vertices.push_back({x, y, z});
    }
    expect("endloop");
    expect("endfacet");
    add_triangle(mesh_);
  }

  MeshText text_;
  const std::string& name_;
  const std::string& key_;
  TriangleMesh mesh_;
};

}  // namespace

TriangleMesh parse_stl(std::string_view bytes, const std::string& name, const std::string& key) {
  if (!is_binary(bytes) && !is(MeshText(bytes).word(), "solid")) {
    const bool has_header = bytes.size() >= header_bytes;
    throw CaseError(
        key,
        has_header
            ? fmt::format("{} does not begin with \"solid\", and as a binary STL its {} triangles "
                          "would take {} bytes, it has {}",
                          name, triangles_of_header(bytes),
                          header_bytes + triangle_bytes * triangles_of_header(bytes), bytes.size())
            : fmt::format("{} is too short for an STL", name),
        "write the file again");
  }
  TriangleMesh mesh =
      is_binary(bytes) ? parse_binary(bytes, name, key) : AsciiStl(bytes, name, key).read();
  if (mesh.triangles.empty())
    throw CaseError(key, name + " has no triangles", "export the surface of a solid");
  return mesh;
}

}  // namespace sabo
