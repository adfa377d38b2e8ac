#include "app/suggestions.hpp"

#include <vector>

#include <fmt/format.h>

#include "base/faults.hpp"

namespace sabo {
namespace {

std::string did_you_mean(const std::string& word, const std::vector<std::string>& candidates) {
  const std::string near = nearest_word(word, candidates);
  return near.empty() ? "" : fmt::format("; did you mean \"{}\"?", near);
}

/// The command that was named, or the program itself.
const CLI::App& named_command(const CLI::App& program) {
  const auto commands = program.get_subcommands();
  return commands.empty() ? program : *commands.front();
}

std::vector<std::string> long_options(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

}  // namespace

std::string fault_of_command(const CLI::App& program, const std::string& word) {
  if (word.starts_with('-')) return "";
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands(nullptr)) {
    if (command->get_name() == word) return "";
    names.push_back(command->get_name());
  }
  const std::string suggestion = did_you_mean(word, names);
  return fmt::format("there is no command \"{}\"{}", word,
                     suggestion.empty() ? "; `sabo --help` lists them" : suggestion);
}

std::string explained(const CLI::App& program, const CLI::ParseError& error) {
  const CLI::App& command = named_command(program);
  for (const std::string& word : program.remaining(true)) {
    if (!word.starts_with("--")) continue;
    const std::string option = word.substr(0, word.find('='));
    return fmt::format("{} has no option {}{}", command.get_name(), option,
                       did_you_mean(option, long_options(command)));
  }
  const std::string name = &command == &program ? "" : " " + command.get_name();
  return fmt::format("{}; see `sabo{} --help`", error.what(), name);
}

}  // namespace sabo
