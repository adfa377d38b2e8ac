#include <charconv>
#include <cstdint>
#include <vector>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/shown_text.hpp"
#include "io/mesh/mesh_text.hpp"
#include "io/mesh/read_mesh.hpp"

namespace sabo {
namespace {

/// Reads the lines "v x y z" and "f a b c ..."; all others are of no use here.
class Obj {
 public:
  Obj(std::string_view text, const std::string& name, const std::string& key)
      : text_(text), name_(name), key_(key) {}

  TriangleMesh read() {
    while (!text_.is_over()) {
      const std::string_view word = text_.word_of_line();
      if (word == "v") read_vertex();
      if (word == "f") read_face();
      text_.skip_line();
    }
    if (mesh_.triangles.empty())
      throw CaseError(key_, name_ + " has no faces (lines that begin with f)",
                      "export the surface of a solid");
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void refuse(const std::string& problem) const {
    throw CaseError(key_, fmt::format("{}, line {}: {}", name_, text_.line(), problem),
                    "write the file again, or give an STL");
  }

  void read_vertex() {
    double x[3];
    for (double& coordinate : x) {
      const std::string_view word = text_.word_of_line();
      if (word.empty()) refuse("a vertex has fewer than three numbers");
      const auto number = number_of(word);
      if (!number) refuse(fmt::format("\"{}\" is not a number", shown_text(word)));
      coordinate = *number;
    }
    if (mesh_.vertices.size() == 3 * max_mesh_triangles)
      refuse(fmt::format("more than {} vertices", 3 * max_mesh_triangles));
    mesh_.vertices.push_back({x[0], x[1], x[2]});
  }

  /// The vertex of "7", "7/1", "7//3" or "7/1/3"; -1 is the last one.
  std::uint32_t vertex_of(std::string_view word) const {
    const std::string_view digits = word.substr(0, word.find('/'));
    std::int64_t number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (digits.empty() || error != std::errc{} || end != digits.data() + digits.size())
      refuse(fmt::format("\"{}\" is not the number of a vertex", shown_text(word)));
    const auto count = static_cast<std::int64_t>(mesh_.vertices.size());
    const std::int64_t index = number < 0 ? count + number : number - 1;
    if (number == 0 || index < 0 || index >= count)
      refuse(fmt::format("there is no vertex {} among the {} before it", number, count));
    return static_cast<std::uint32_t>(index);
  }

  /// Cuts a face into triangles around its first corner.
  void read_face() {
    corners_.clear();
    for (std::string_view word = text_.word_of_line(); !word.empty() && word.front() != '#';
         word = text_.word_of_line())
      corners_.push_back(vertex_of(word));
    if (corners_.size() < 3) refuse("a face has fewer than three vertices");
    if (mesh_.triangles.size() + corners_.size() - 2 > max_mesh_triangles)
      refuse(fmt::format("more than {} triangles", max_mesh_triangles));
    for (std::size_t k = 2; k < corners_.size(); ++k)
      mesh_.triangles.push_back({corners_[0], corners_[k - 1], corners_[k]});
  }

  MeshText text_;
  const std::string& name_;
  const std::string& key_;
  TriangleMesh mesh_;
  std::vector<std::uint32_t> corners_;
};

}  // namespace

TriangleMesh parse_obj(std::string_view text, const std::string& name, const std::string& key) {
  return Obj(text, name, key).read();
}

}  // namespace sabo
