#pragma once

#include <string>

namespace sabo {

/// Opens an address in the user's browser (xdg-open), where there is a display.
void open_browser(const std::string& address);

}  // namespace sabo
