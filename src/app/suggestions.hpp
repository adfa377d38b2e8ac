#pragma once

#include <string>

#include <CLI/App.hpp>

namespace sabo {

/// What is wrong with `word`, the first of the command line, when it is neither an option nor a
/// command, with the nearest command; "" when it is one.
std::string fault_of_command(const CLI::App& program, const std::string& word);

/// What is wrong with the command line, with the nearest option for an unknown one.
std::string explained(const CLI::App& program, const CLI::ParseError& error);

}  // namespace sabo
