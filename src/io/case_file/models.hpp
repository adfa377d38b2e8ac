#pragma once

#include <string>

namespace sabo {

/// Every rheology with its keys, defaults, ranges and units, and every material preset with its
/// source, for `sabo models`.
std::string models_text();

/// The laws as a table in Markdown whose links start with `folder`, where their pages are.
std::string laws_table(const std::string& folder);

/// The material presets with their values, sources and cautions in Markdown.
std::string presets_markdown();

}  // namespace sabo
