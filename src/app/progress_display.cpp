#include "app/progress_display.hpp"

#include <fmt/format.h>

#include "app/terminal.hpp"

namespace sabo {
namespace {

constexpr double redraw_interval = 0.2;   // s
constexpr double new_line_interval = 10;  // s
constexpr int plain_width = 200;          // columns where nobody looks at a terminal
constexpr const char* clear_to_end = "\x1b[K";

}  // namespace

ProgressDisplay::ProgressDisplay(bool has_dam) : has_dam_(has_dam), redraws_(is_terminal(stdout)) {}

void ProgressDisplay::show(const RunProgress& progress) {
  if (progress.wall < next_) return;
  next_ = progress.wall + (redraws_ ? redraw_interval : new_line_interval);
  pace_.update(progress);
  if (redraws_) {
    // The last column stays free: some terminals wrap when it is filled.
    const int width = columns_of(stdout) - 1;
    fmt::print("\r{}{}", progress_bar(progress, pace_, has_dam_, width), clear_to_end);
    is_line_open_ = true;
  } else {
    fmt::print("{}\n", progress_text(progress, pace_, has_dam_, plain_width));
  }
  std::fflush(stdout);
}

void ProgressDisplay::finish() {
  if (is_line_open_) fmt::print("\n");
  is_line_open_ = false;
}

}  // namespace sabo
