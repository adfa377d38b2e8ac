#include "io/case_file/read_value.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "io/case_file/text_check.hpp"

namespace sabo {
namespace {

constexpr std::size_t max_text = 1000;  // characters of a text, bytes of a path
constexpr double max_coordinate = 1e8;  // m

std::string shortened(const std::string& text) {
  constexpr std::size_t limit = 40;
  if (text.size() <= limit) return text;
  std::size_t end = limit;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80) --end;
  return text.substr(0, end) + "...";
}

/// What stands in the file, for a message.
std::string found_text(const TomlNode& node) {
  struct Visitor {
    std::string operator()(bool value) const { return value ? "true" : "false"; }
    std::string operator()(std::int64_t value) const { return fmt::format("{}", value); }
    std::string operator()(double value) const { return fmt::format("{}", value); }
    std::string operator()(const std::string& value) const {
      return fmt::format("the text \"{}\"", shortened(value));
    }
    std::string operator()(const TomlDate&) const { return "a date or time"; }
    std::string operator()(const TomlArray&) const { return "a list"; }
    std::string operator()(const TomlTable&) const { return "a table"; }
  };
  return std::visit(Visitor{}, node.value);
}

std::optional<double> number_in(const TomlNode& node) {
  if (const auto* integer = std::get_if<std::int64_t>(&node.value)) {
    return static_cast<double>(*integer);
  }
  if (const auto* number = std::get_if<double>(&node.value)) return *number;
  return std::nullopt;
}

/// Whether a number may be used; a fault when it may not.
bool accept(const FoundKey& found, double value, const std::string& wanted) {
  if (std::isfinite(value) && found.key.accepts(value)) return true;
  const char* reason = std::isfinite(value) ? "is out of range" : "is not a finite number";
  found.faults.add(found.path, fmt::format("{} {}", value, reason), "give " + wanted);
  return false;
}

/// A text without control characters; a fault when it is none.
std::optional<std::string> read_text(const FoundKey& found, const std::string& wanted) {
  const auto* text = std::get_if<std::string>(&found.node.value);
  if (!text) {
    found.refuse_type(wanted);
    return std::nullopt;
  }
  if (std::any_of(text->begin(), text->end(), is_control)) {
    found.faults.add(found.path, "has a line break or a control character", "remove it");
    return std::nullopt;
  }
  if (text->size() > max_text) {
    found.faults.add(found.path, fmt::format("is longer than {} characters", max_text),
                     "shorten it");
    return std::nullopt;
  }
  return *text;
}

std::optional<std::filesystem::path> read_file_name(const FoundKey& found,
                                                    const std::string& wanted) {
  const auto name = read_text(found, wanted);
  if (!name) return std::nullopt;
  if (name->empty()) {
    found.faults.add(found.path, "the file name is empty", "give a file name or remove the key");
    return std::nullopt;
  }
  const std::filesystem::path path = (found.folder / *name).lexically_normal();
  if (found.files_may_be_gone) return path;
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    found.faults.add(found.path, "there is no file " + path.string(),
                     "check the name; it starts at the folder of the case file");
    return std::nullopt;
  }
  // Pipes and devices have no end, or none that comes by itself.
  if (!std::filesystem::is_regular_file(path, error) &&
      !std::filesystem::is_directory(path, error)) {
    found.faults.add(found.path, path.string() + " is no ordinary file",
                     "give the name of a file or a folder");
    return std::nullopt;
  }
  return path;
}

/// One point of two or three finite numbers; its size, or 0 when it is none.
std::size_t read_point(const TomlNode& node, std::array<double, 3>& point) {
  const auto* numbers = std::get_if<TomlArray>(&node.value);
  if (!numbers || numbers->size() < 2 || numbers->size() > 3) return 0;
  for (std::size_t i = 0; i < numbers->size(); ++i) {
    const auto value = number_in((*numbers)[i]);
    if (!value || !(std::abs(*value) <= max_coordinate)) return 0;
    point[i] = *value;
  }
  return numbers->size();
}

void read_points(const FoundKey& found, const TomlArray& points, LineSource& member) {
  LineSource line;
  std::size_t size = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::array<double, 3> point{};
    const std::size_t point_size = read_point(points[i], point);
    if (point_size == 0) {
      found.faults.add(found.path, fmt::format("point {} is not [x, y] or [x, y, z]", i + 1),
                       fmt::format("give numbers up to {} m", short_text(max_coordinate)));
      return;
    }
    if (i == 0) size = point_size;
    if (point_size != size) {
      found.faults.add(found.path, "some points have z and some have not",
                       "give z for all or for none");
      return;
    }
    line.coordinates.push_back(point);
  }
  if (line.coordinates.size() < 2) {
    found.faults.add(found.path, "has fewer than two points", "give two or more");
    return;
  }
  line.has_z = size == 3;
  member = std::move(line);
}

}  // namespace

void FoundKey::refuse_type(const std::string& wanted) const {
  faults.add(path, "found " + found_text(node), "give " + wanted);
}

void read_value(const FoundKey& found, bool& member) {
  if (const auto* value = std::get_if<bool>(&found.node.value)) {
    member = *value;
  } else {
    found.refuse_type(wanted_text<bool>(found.key));
  }
}

void read_value(const FoundKey& found, int& member) {
  const std::string wanted = wanted_text<int>(found.key);
  const auto* value = std::get_if<std::int64_t>(&found.node.value);
  if (!value) {
    found.refuse_type(wanted);
  } else if (accept(found, static_cast<double>(*value), wanted)) {
    member = static_cast<int>(*value);
  }
}

void read_value(const FoundKey& found, double& member) {
  const std::string wanted = wanted_text<double>(found.key);
  const auto value = number_in(found.node);
  if (!value) {
    found.refuse_type(wanted);
  } else if (accept(found, *value, wanted)) {
    member = *value;
  }
}

void read_value(const FoundKey& found, std::string& member) {
  if (auto text = read_text(found, wanted_text<std::string>(found.key))) member = std::move(*text);
}

void read_value(const FoundKey& found, std::filesystem::path& member) {
  const std::string wanted = wanted_text<std::filesystem::path>(found.key);
  if (auto path = read_file_name(found, wanted)) member = std::move(*path);
}

void read_value(const FoundKey& found, LineSource& member) {
  if (const auto* points = std::get_if<TomlArray>(&found.node.value)) {
    read_points(found, *points, member);
  } else if (auto path = read_file_name(found, wanted_text<LineSource>(found.key))) {
    member = LineSource{std::move(*path), {}, false};
  }
}

void read_value(const FoundKey& found, Rheology& member) {
  const auto index = read_word(found, rheology_names());
  if (index && *index != member.index()) member = all_rheologies()[*index];
}

void read_value(const FoundKey& found, PresetName& member) {
  const std::vector<std::string> names = preset_names();
  if (const auto index = read_word(found, names)) member.name = names[*index];
}

void read_numbers(const FoundKey& found, std::span<double> members, const std::string& wanted) {
  const auto* items = std::get_if<TomlArray>(&found.node.value);
  if (!items) return found.refuse_type(wanted);
  if (items->size() != members.size()) {
    return found.faults.add(found.path, fmt::format("found a list of {}", items->size()),
                            "give " + wanted);
  }
  std::vector<double> values;
  for (const TomlNode& item : *items) {
    const auto value = number_in(item);
    if (!value) {
      return found.faults.add(found.path, fmt::format("found {} in the list", found_text(item)),
                              "give " + wanted);
    }
    if (!accept(found, *value, wanted)) return;
    values.push_back(*value);
  }
  std::copy(values.begin(), values.end(), members.begin());
}

std::optional<std::size_t> read_word(const FoundKey& found, const std::vector<std::string>& words) {
  const auto* word = std::get_if<std::string>(&found.node.value);
  if (!word) {
    found.refuse_type(words_text(words));
    return std::nullopt;
  }
  const auto at = std::find(words.begin(), words.end(), *word);
  if (at == words.end()) {
    found.faults.add(found.path, fmt::format("\"{}\" is not known", shortened(*word)),
                     "give " + words_text(words));
    return std::nullopt;
  }
  return static_cast<std::size_t>(at - words.begin());
}

}  // namespace sabo
