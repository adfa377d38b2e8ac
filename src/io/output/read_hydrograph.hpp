#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "case/hydrograph.hpp"

namespace sabo {

/// The hydrograph of a CSV text: a line of names, time [s], discharge [m3/s] and perhaps
/// speed [m/s], in any order and with or without their units, then a line for each time. Empty
/// lines and a byte order mark are passed over. Throws CaseError at `place` where the text is no
/// such table, a number is missing or out of range, times do not increase, nothing flows, or a
/// discharge has no speed; `name` is that of the file.
Hydrograph parse_hydrograph(std::string_view text, const std::string& place,
                            const std::string& name);

/// The same of a file, of up to 100 MB.
Hydrograph read_hydrograph(const std::filesystem::path& file, const std::string& place);

}  // namespace sabo
