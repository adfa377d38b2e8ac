#include "io/case_file/models.hpp"

#include <fmt/format.h>

#include "case/material_presets.hpp"
#include "io/case_file/listing.hpp"

namespace sabo {
namespace {

std::string_view summary_of(const Rheology& law) {
  return std::visit([](const auto& l) { return std::string_view(l.summary); }, law);
}

/// The keys of a preset as they would be written in a case: "density = 1660, ...".
std::string values_of(const MaterialPreset& preset) {
  std::string text =
      fmt::format("density = {}, rheology = \"{}\"", preset.density, name_of(preset.law));
  for (const ListedKey& key : list_keys(preset.law, preset.yield))
    text += fmt::format(", {} = {}", key.name, key.value);
  return text;
}

}  // namespace

std::string models_text() {
  std::string text;
  for (const Rheology& law : all_rheologies()) {
    text += fmt::format("{}rheology = \"{}\": {}\n", text.empty() ? "" : "\n", name_of(law),
                        summary_of(law));
    for (const ListedKey& key : list_keys(law)) {
      text += fmt::format("  {:<22} {:<7} {}\n", key.name, key.value, key.help);
      text += fmt::format("  {:<30} {}\n", "", key.wanted);
    }
  }
  for (const MaterialPreset& preset : material_presets()) {
    text += fmt::format("\npreset = \"{}\": {}\n  {}\n  Source: {}\n  Caution: {}\n", preset.name,
                        preset.summary, values_of(preset), preset.source, preset.caution);
  }
  return text;
}

std::string laws_table(const std::string& folder) {
  std::string text = "| `rheology` | law | yield stress |\n|---|---|---|\n";
  for (const Rheology& law : all_rheologies()) {
    text += fmt::format("| [`{0}`]({1}{0}.md) | {2} | {3} |\n", name_of(law), folder,
                        summary_of(law), has_yield(law) ? "yes" : "no");
  }
  return text;
}

std::string presets_markdown() {
  std::string text;
  for (const MaterialPreset& preset : material_presets()) {
    text += fmt::format("{}**`{}`** · {}.\n\n- Values: `{}`\n- Source: {}.\n- Caution: {}.\n",
                        text.empty() ? "" : "\n", preset.name, preset.summary, values_of(preset),
                        preset.source, preset.caution);
  }
  return text;
}

}  // namespace sabo
