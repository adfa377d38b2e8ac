#pragma once

#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "io/case_file/read_case.hpp"

namespace sabo {

/// Adds the option --KEY to a command: it stands for a key of the case and takes its help from
/// there. When it is given, its value is appended to `overrides`, which must outlive the command;
/// the reader of the case checks it.
void add_case_option(CLI::App& command, const std::string& table, const std::string& key,
                     std::vector<Override>& overrides);

/// The ones for how long and how a case is run: --duration, --method, --backend, --threads.
void add_run_options(CLI::App& command, std::vector<Override>& overrides);

}  // namespace sabo
