#include "io/output/view_frame.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "io/output/base64.hpp"

namespace sabo {
namespace {

constexpr std::size_t fields = std::tuple_size_v<decltype(ViewFrame::values)>;

struct Span {
  float low = 0;
  float high = 0;
};

Span span_of(const std::vector<float>& values) {
  if (values.empty()) return {};
  const auto [low, high] = std::ranges::minmax(values);
  return {low, high};
}

bool are_counted(const std::vector<std::uint32_t>& ids) {
  return ids.empty() || (ids.front() == 0 && ids.back() + std::size_t{1} == ids.size());
}

}  // namespace

std::uint16_t quantised(double value, double low, double high, int steps) {
  if (!(high > low)) return 0;
  const double share = std::clamp((value - low) / (high - low), 0.0, 1.0);
  return static_cast<std::uint16_t>(std::lround(share * steps));
}

void append_bytes(std::vector<std::byte>& bytes, std::uint32_t number, int count) {
  for (int k = 0; k < count; ++k) bytes.push_back(static_cast<std::byte>(number >> (8 * k)));
}

std::string packed(const std::vector<std::uint16_t>& numbers) {
  std::vector<std::byte> bytes;
  bytes.reserve(2 * numbers.size());
  for (const std::uint16_t number : numbers) append_bytes(bytes, number, 2);
  return base64_of(bytes);
}

std::string view_frame_script(std::size_t number, const ViewFrame& frame) {
  std::array<Span, fields> spans;
  for (std::size_t k = 0; k < fields; ++k) spans[k] = span_of(frame.values[k]);
  const std::size_t count = frame.id.size();
  std::vector<std::uint16_t> numbers;
  numbers.reserve(fields * count);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < fields; ++k)
      numbers.push_back(quantised(frame.values[k][i], spans[k].low, spans[k].high));

  std::string low, high;
  for (const Span& span : spans) {
    low += fmt::format("{}{:.9g}", low.empty() ? "" : ",", span.low);
    high += fmt::format("{}{:.9g}", high.empty() ? "" : ",", span.high);
  }
  std::string ids;
  if (!are_counted(frame.id)) {
    std::vector<std::byte> bytes;
    for (const std::uint32_t id : frame.id) append_bytes(bytes, id, 4);
    ids = base64_of(bytes);
  }
  return fmt::format(
      "sabo_frame({{\"number\":{},\"count\":{},\"low\":[{}],\"high\":[{}],\"ids\":\"{}\",\n"
      "\"values\":\"{}\"}});\n",
      number, count, low, high, ids, packed(numbers));
}

std::string view_frame_file(std::size_t number) { return fmt::format("frame_{:05}.js", number); }

}  // namespace sabo
