#include "app/progress_line.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "run/amount_text.hpp"

namespace sabo {
namespace {

constexpr double memory_of_pace = 20;  // s

double share_done(const RunProgress& p) {
  return p.duration > 0 ? std::clamp(p.time / p.duration, 0.0, 1.0) : 0;
}

/// "0:42", "12:05", "3:07:00"
std::string clock_text(double seconds) {
  const auto total = static_cast<long>(std::min(seconds, 3.6e8));
  const long hours = total / 3600;
  const long minutes = total / 60 % 60;
  return hours > 0 ? fmt::format("{}:{:02}:{:02}", hours, minutes, total % 60)
                   : fmt::format("{}:{:02}", minutes, total % 60);
}

std::string volumes_text(const VolumeRow& v, bool has_dam) {
  std::string text =
      has_dam ? fmt::format("trapped {} beyond {}", amount_text(v.trapped), amount_text(v.beyond))
              : "on the map " + amount_text(v.trapped + v.beyond);
  if (v.outflow > 0) text += " left " + amount_text(v.outflow);
  return text + " m3";
}

/// Most important first.
std::vector<std::string> parts_of(const RunProgress& p, const Pace& pace, bool has_dam) {
  const auto left = pace.seconds_left();
  return {fmt::format("{:3.0f} %", std::floor(100 * share_done(p))),
          fmt::format("{:.1f}/{:g} s", p.time, p.duration),
          left ? clock_text(*left) + " left" : "-:-- left",
          fmt::format("front {} m {:.1f} m/s", amount_text(p.front.position), p.front.velocity),
          fmt::format("fastest {:.1f} m/s", p.fastest),
          volumes_text(p.volumes, has_dam),
          fmt::format("{:.0f} steps/s", pace.steps_per_second()),
          fmt::format("dt {:.3g} ms", 1e3 * p.dt)};
}

}  // namespace

void Pace::update(const RunProgress& progress) {
  const double wall = progress.wall - last_wall_;
  const auto steps = static_cast<double>(progress.steps);
  const double kept = std::exp(-std::max(0.0, wall) / memory_of_pace);
  if (has_begun_) {  // a run may begin at any time, from the state of another
    wall_ = kept * wall_ + wall;
    time_ = kept * time_ + progress.time - last_time_;
    steps_ = kept * steps_ + steps - last_steps_;
  }
  has_begun_ = true;
  last_wall_ = progress.wall;
  last_time_ = progress.time;
  last_steps_ = steps;
  time_left_ = std::max(0.0, progress.duration - progress.time);
}

std::optional<double> Pace::seconds_left() const {
  if (!(time_ > 0)) return {};
  return time_left_ * wall_ / time_;
}

std::string progress_text(const RunProgress& progress, const Pace& pace, bool has_dam, int width) {
  const auto room = static_cast<std::size_t>(std::max(0, width));
  std::string text;
  for (const std::string& part : parts_of(progress, pace, has_dam)) {
    const std::string_view gap = text.empty() ? "" : "  ";
    if (text.size() + gap.size() + part.size() > room) break;
    text.append(gap).append(part);
  }
  return text;
}

std::string progress_bar(const RunProgress& progress, const Pace& pace, bool has_dam, int width) {
  constexpr int shortest = 12, longest = 32;  // with its brackets and the space after it
  const std::string text = progress_text(progress, pace, has_dam, width - shortest);
  const int room = std::min(longest, width - static_cast<int>(text.size()));
  if (text.empty() || room < shortest) return progress_text(progress, pace, has_dam, width);
  const int cells = room - 3;
  const int done = static_cast<int>(cells * share_done(progress));
  return fmt::format("[{:=<{}}{:<{}}] {}", "", done, "", cells - done, text);
}

}  // namespace sabo
