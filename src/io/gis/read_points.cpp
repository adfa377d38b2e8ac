#include "io/gis/read_points.hpp"

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/shown_text.hpp"

namespace sabo {
namespace {

constexpr const char* points_key = "release.points";
constexpr const char* points_form = "give one point per line: x y z";
constexpr std::size_t max_points = 100'000'000;
constexpr std::size_t max_line = 4096;  // bytes

std::string_view without_comment(std::string_view line) {
  line = line.substr(0, line.find('#'));
  const std::size_t last = line.find_last_not_of(" \t\r");
  line = last == std::string_view::npos ? std::string_view{} : line.substr(0, last + 1);
  const std::size_t first = line.find_first_not_of(" \t");
  return first == std::string_view::npos ? std::string_view{} : line.substr(first);
}

// Takes one finite number and the separator behind it off the text.
std::optional<double> take_number(std::string_view& text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || !std::isfinite(value)) return std::nullopt;
  text.remove_prefix(end - text.data());
  if (text.empty()) return value;

  const auto skip_blanks = [&text] {
    text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
  };
  const std::size_t before = text.size();
  skip_blanks();
  if (text.starts_with(',')) {
    text.remove_prefix(1);
    skip_blanks();
  }
  return text.size() < before ? std::optional(value) : std::nullopt;
}

std::optional<Vec3d> point_of(std::string_view text) {
  std::array<double, 3> p{};
  for (double& coordinate : p) {
    const std::optional<double> number = take_number(text);
    if (!number) return std::nullopt;
    coordinate = *number;
  }
  if (!text.empty()) return std::nullopt;
  return Vec3d{p[0], p[1], p[2]};
}

}  // namespace

std::vector<Vec3d> read_points(const std::filesystem::path& file, const Vec3d& offset) {
  const std::string name = file.string();
  std::error_code ignored;
  std::ifstream in(file);
  if (!in || std::filesystem::is_directory(file, ignored)) {
    throw CaseError(points_key, name + " cannot be opened",
                    "give a path relative to the case file");
  }
  const auto refuse = [&name](std::size_t number, const std::string& problem) {
    throw CaseError(points_key, fmt::format("{}, line {}: {}", name, number, problem), points_form);
  };
  std::vector<Vec3d> points;
  std::array<char, max_line> buffer{};
  bool may_be_header = true;
  for (std::size_t number = 1; in.getline(buffer.data(), buffer.size()) || in.gcount() > 0;
       ++number) {
    if (in.fail()) refuse(number, fmt::format("longer than {} characters", max_line));
    std::string_view line(buffer.data());
    if (number == 1 && line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
    line = without_comment(line);
    if (line.empty()) continue;
    const std::optional<Vec3d> point = point_of(line);
    const bool is_header =
        may_be_header && !point && std::isalpha(static_cast<unsigned char>(line[0]));
    may_be_header = false;
    if (is_header) continue;
    if (!point) refuse(number, fmt::format("\"{}\" is not a point", shown_text(line)));
    if (points.size() == max_points) refuse(number, fmt::format("more than {} points", max_points));
    points.push_back(*point + offset);
  }
  if (points.empty()) throw CaseError(points_key, name + " has no points", points_form);
  return points;
}

}  // namespace sabo
