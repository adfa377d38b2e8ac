#include "io/output/read_vtp.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/parsed_number.hpp"
#include "io/output/read_appended.hpp"
#include "io/output/read_file.hpp"
#include "io/output/vtk_appended.hpp"
#include "io/output/xml_elements.hpp"

namespace sabo {
namespace {

constexpr std::size_t largest_frame = std::size_t{1} << 36;  // bytes
constexpr std::size_t largest_list = std::size_t{1} << 26;
constexpr std::uint64_t most_particles = std::numeric_limits<std::int32_t>::max();
constexpr int most_components = 9;
constexpr std::string_view data_begin = "<AppendedData encoding=\"raw\">\n_";
constexpr std::string_view data_end = "\n</AppendedData>\n</VTKFile>\n";

std::string content_of(const std::filesystem::path& file, std::size_t max_bytes) {
  std::optional<std::string> content = read_file(file, max_bytes);
  if (content) return std::move(*content);
  throw CaseError(file.string(), "cannot be read, or is empty",
                  "give a file of the folder frames of a run");
}

// A DataArray element and the element it stands in.
struct ArrayElement {
  std::string_view section;
  const XmlTag* tag = nullptr;
};

// Reads one frame; every fault ends in fail().
class FrameReader {
 public:
  FrameReader(std::string_view bytes, std::string place) : place_(std::move(place)) {
    const std::size_t begin = bytes.find(data_begin);
    if (begin == bytes.npos) fail("is not a frame of this program: it has no appended raw data");
    if (!bytes.ends_with(data_end) || bytes.size() < begin + data_begin.size() + data_end.size()) {
      fail("is not complete: its end is missing");
    }
    auto tags = xml_tags(bytes.substr(0, begin));
    if (!tags) fail("is damaged in its part of text");
    tags_ = std::move(*tags);
    bytes.remove_suffix(data_end.size());
    bytes.remove_prefix(begin + data_begin.size());
    data_ = bytes;
  }

  ParticleFrame read() {
    check_kind();
    collect();
    AppendedReader data(data_, place_);
    ParticleFrame frame;
    frame.time = ascii("TimeValue", 1)[0];
    const std::vector<double> origin = ascii("origin [m]", 3);
    frame.origin = {origin[0], origin[1], origin[2]};
    // In the order of the bytes: the positions come first.
    for (const ArrayElement& element : arrays_) {
      if (element.section != "Points") continue;
      const ParticleArray position = read_array(data, *element.tag);
      if (position.components != 3 || !frame.points.empty()) fail("has more than one position");
      frame.points.reserve(count_);
      for (std::size_t i = 0; i < count_; ++i) {
        const float* p = &position.values[3 * i];
        frame.points.push_back({p[0], p[1], p[2]});
      }
    }
    if (frame.points.size() != count_) fail("has no positions");
    for (const ArrayElement& element : arrays_) {
      if (element.section != "PointData") continue;
      frame.arrays.push_back(read_array(data, *element.tag));
    }
    return frame;
  }

 private:
  [[noreturn]] void fail(const std::string& problem) const {
    throw CaseError(place_, problem, damaged_frame_remedy);
  }

  std::string attribute(const XmlTag& tag, const char* name) const {
    const auto value = tag.attribute(name);
    if (!value) fail(fmt::format("has a {} without {}", std::string(tag.name), name));
    return *value;
  }

  void check_kind() const {
    if (tags_.empty() || tags_.front().name != "VTKFile") fail("is not a VTK file");
    constexpr std::array<std::pair<const char*, const char*>, 4> expected{
        {{"type", "PolyData"},
         {"byte_order", vtk_byte_order},
         {"header_type", "UInt64"},
         {"compressor", "vtkZLibDataCompressor"}}};
    for (const auto& [name, value] : expected) {
      const std::string found = attribute(tags_.front(), name);
      if (found != value) {
        fail(fmt::format("is not a frame of this program: {} is {} instead of {}", name, found,
                         value));
      }
    }
  }

  // The number of particles and the arrays with the sections they stand in.
  void collect() {
    std::string_view section;
    bool has_piece = false;
    for (const XmlTag& tag : tags_) {
      if (tag.name == "DataArray") {
        arrays_.push_back({section, &tag});
      } else if (tag.name == "Piece") {
        const auto count = finite_number<std::uint64_t>(attribute(tag, "NumberOfPoints"));
        if (has_piece || !count || *count > most_particles) {
          fail("does not say how many particles it has");
        }
        count_ = *count;
        has_piece = true;
      } else if (tag.name != "/DataArray") {
        section = tag.name;
      }
    }
    if (!has_piece) fail("does not say how many particles it has");
  }

  std::vector<double> ascii(std::string_view name, std::size_t count) const {
    for (const ArrayElement& element : arrays_) {
      if (element.section != "FieldData" || element.tag->attribute("Name") != name) continue;
      std::vector<double> values;
      std::string_view text = element.tag->text;
      while (!text.empty()) {
        const std::string_view word = text.substr(0, text.find(' '));
        text.remove_prefix(std::min(text.size(), word.size() + 1));
        const auto value = finite_number<double>(word);
        if (!value) break;
        values.push_back(*value);
      }
      if (values.size() == count) return values;
    }
    fail(fmt::format("has no valid \"{}\"", name));
  }

  ParticleArray read_array(AppendedReader& data, const XmlTag& tag) const {
    ParticleArray array;
    array.name = attribute(tag, "Name");
    const std::string type = attribute(tag, "type");
    const auto components = finite_number<int>(attribute(tag, "NumberOfComponents"));
    const auto offset = finite_number<std::uint64_t>(attribute(tag, "offset"));
    const bool is_known = (type == "Float32" || type == "UInt32") && components &&
                          *components >= 1 && *components <= most_components && offset;
    if (!is_known || attribute(tag, "format") != "appended") {
      fail(fmt::format("has an array \"{}\" that this program does not write", array.name));
    }
    array.components = *components;
    const std::size_t values = count_ * array.components;
    const std::vector<std::byte> bytes = data.read(*offset, values * sizeof(float), array.name);
    array.values.resize(values);
    if (values == 0) return array;
    std::memcpy(array.values.data(), bytes.data(), bytes.size());
    for (float& value : array.values) {
      if (type == "UInt32") value = static_cast<float>(std::bit_cast<std::uint32_t>(value));
      if (!std::isfinite(value)) fail(fmt::format("has {} in \"{}\"", value, array.name));
    }
    return array;
  }

  std::string place_;
  std::vector<XmlTag> tags_;
  std::string_view data_;
  std::vector<ArrayElement> arrays_;
  std::uint64_t count_ = 0;
};

bool stays_inside(const std::string& name) {
  const std::filesystem::path path(name);
  if (name.empty() || name.find('\0') != name.npos || path.is_absolute()) return false;
  for (const std::filesystem::path& part : path) {
    if (part == "..") return false;
  }
  return true;
}

}  // namespace

const ParticleArray* ParticleFrame::find(std::string_view name) const {
  for (const ParticleArray& array : arrays) {
    if (array.name == name) return &array;
  }
  return nullptr;
}

ParticleFrame parse_particles_vtp(std::string_view bytes, const std::string& place) {
  return FrameReader(bytes, place).read();
}

ParticleFrame read_particles_vtp(const std::filesystem::path& file) {
  return parse_particles_vtp(content_of(file, largest_frame), file.string());
}

std::vector<PvdEntry> parse_pvd(std::string_view text, const std::string& place) {
  const auto fail = [&place](const std::string& problem) {
    throw CaseError(place, problem, "run the case again, or name the frames one by one");
  };
  const auto tags = xml_tags(text);
  if (!tags || tags->size() < 4 || tags->front().name != "VTKFile" ||
      tags->front().attribute("type") != "Collection" || tags->back().name != "/VTKFile") {
    fail("is not a complete list of frames");
  }
  std::vector<PvdEntry> entries;
  for (const XmlTag& tag : *tags) {
    if (tag.name != "DataSet") continue;
    const auto time = finite_number<double>(tag.attribute("timestep").value_or(""));
    const std::string name = tag.attribute("file").value_or("");
    if (!time) fail(fmt::format("frame {} has no valid time", entries.size() + 1));
    if (!stays_inside(name)) {
      fail(fmt::format("frame {} is \"{}\", which is not in the folder of the list",
                       entries.size() + 1, name));
    }
    entries.push_back({*time, name});
  }
  return entries;
}

std::vector<PvdEntry> read_pvd(const std::filesystem::path& file) {
  return parse_pvd(content_of(file, largest_list), file.string());
}

}  // namespace sabo
