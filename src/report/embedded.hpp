#pragma once

#include <string_view>

namespace sabo {

// Files that are compiled in. See src/CMakeLists.txt.

std::string_view report_text_en();      ///< src/report/text/en.toml
std::string_view report_text_ja();      ///< src/report/text/ja.toml
std::string_view report_sources();      ///< src/report/text/sources.toml
std::string_view report_script();       ///< web/report/dist/report.js
std::string_view report_script_hash();  ///< its SHA-256 in base 64
std::string_view report_style();        ///< web/report/dist/report.css

}  // namespace sabo
