#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace sabo {

/// Lines under labels, then what to be aware of.
class Preview {
 public:
  /// A line under a label; a label is printed once.
  void line(std::string_view label, const std::string& text) {
    text_ += fmt::format("{:<12}{}\n", label == label_ ? "" : label, text);
    label_ = label;
  }
  void warn(std::string text) { warnings_.push_back(std::move(text)); }

  std::string text() const {
    std::string all = text_;
    if (!warnings_.empty()) all += "\nBe aware:\n";
    for (const std::string& warning : warnings_) all += "  - " + warning + "\n";
    return all;
  }

 private:
  std::string text_;
  std::string_view label_;
  std::vector<std::string> warnings_;
};

}  // namespace sabo
