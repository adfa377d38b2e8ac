#include "io/case_file/key_text.hpp"

#include <cmath>

#include <fmt/format.h>

#include "case/material_presets.hpp"

namespace sabo {
std::string short_text(double number) {
  std::string text = fmt::format("{:g}", number);
  const std::size_t exponent = text.find('e');
  if (exponent == std::string::npos) return text;
  std::string digits = text.substr(exponent + 2);
  digits.erase(0, digits.find_first_not_of('0'));
  const char* sign = text[exponent + 1] == '-' ? "-" : "";
  return fmt::format("{}e{}{}", text.substr(0, exponent), sign, digits);
}

std::string range_text(const Key& key) {
  std::string text;
  if (key.min_is_open) {
    text = fmt::format("above {}", short_text(key.min));
    if (std::isfinite(key.max)) text += fmt::format(", at most {}", short_text(key.max));
  } else if (std::isfinite(key.min)) {
    text = std::isfinite(key.max)
               ? fmt::format("from {} to {}", short_text(key.min), short_text(key.max))
               : fmt::format("of at least {}", short_text(key.min));
  } else if (std::isfinite(key.max)) {
    text = fmt::format("of at most {}", short_text(key.max));
  }
  if (key.unit.empty()) return text;
  return text.empty() ? fmt::format("in {}", key.unit) : fmt::format("{} {}", text, key.unit);
}

std::string list_text(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    if (!text.empty()) text += ", ";
    text += word;
  }
  return text;
}

std::string words_text(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? " or " : ", ";
    text += '"' + words[i] + '"';
  }
  return text;
}

std::vector<std::string> rheology_names() {
  std::vector<std::string> names;
  for (const Rheology& law : all_rheologies()) names.emplace_back(name_of(law));
  return names;
}

std::vector<std::string> preset_names() {
  std::vector<std::string> names;
  for (const MaterialPreset& preset : material_presets()) names.emplace_back(preset.name);
  return names;
}

}  // namespace sabo
