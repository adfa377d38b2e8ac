#include "app/messages.hpp"

#include <cstdio>

#include <fmt/color.h>
#include <fmt/format.h>

#include "app/terminal.hpp"

namespace sabo {
namespace {

std::string in_red(const std::string& text) {
  if (!takes_colour(stderr)) return text;
  return fmt::format(fmt::emphasis::bold | fmt::fg(fmt::terminal_color::red), "{}", text);
}

}  // namespace

void print_faults(const std::string& subject, const std::vector<Fault>& faults) {
  if (!subject.empty()) {
    const std::string heading =
        fmt::format("{} fault{} in {}:", faults.size(), faults.size() == 1 ? "" : "s", subject);
    fmt::print(stderr, "{}\n", in_red(heading));
  }
  for (const Fault& fault : faults) {
    subject.empty() ? print_error(to_string(fault))
                    : fmt::print(stderr, "  {}\n", to_string(fault));
  }
}

void print_error(const std::string& message) {
  fmt::print(stderr, "{} {}\n", in_red("error:"), message);
}

}  // namespace sabo
