#pragma once

#include <string_view>

namespace sabo {

// Built by web/viewer and compiled into the program.

/// The page of the 3D view; it reads scene.js and frame_*.js beside it.
std::string_view view_page();

/// The Content-Security-Policy to serve that page with: no scripts but its own and files beside it.
std::string_view view_page_policy();

}  // namespace sabo
