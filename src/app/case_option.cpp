#include "app/case_option.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <type_traits>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sabo {
namespace {

/// What a help text shows for a value: its unit, its words, or that it is a number.
template <class T>
std::string value_name(const Key& key) {
  if constexpr (std::is_enum_v<T>) return fmt::format("{}", fmt::join(Words<T>::list, "|"));
  std::string unit(key.unit);
  std::ranges::transform(unit, unit.begin(), [](unsigned char c) { return std::toupper(c); });
  return unit.empty() ? "N" : unit;
}

struct KeyHelp {
  std::string value_name;
  std::string help;
};

/// Visitor of a Case that finds the help of one key of one table.
class KeyFinder {
 public:
  KeyFinder(std::string_view table, std::string_view key)
      : wanted_table_(table), wanted_key_(key) {}

  template <class T>
  void operator()(const Key& key, T& /*member*/) {
    if (is_inside_ && key.name == wanted_key_) found = {value_name<T>(key), std::string(key.help)};
  }
  template <class T>
  void table(std::string_view name, std::string_view /*help*/, T& member) {
    if (name != wanted_table_) return;
    is_inside_ = true;
    member.describe(*this);
    is_inside_ = false;
  }
  template <class T>
  void tables(std::string_view /*name*/, std::string_view /*help*/, std::vector<T>& /*members*/) {}

  std::optional<KeyHelp> found;

 private:
  std::string_view wanted_table_;
  std::string_view wanted_key_;
  bool is_inside_ = false;
};

}  // namespace

void add_case_option(CLI::App& command, const std::string& table, const std::string& key,
                     std::vector<Override>& overrides) {
  KeyFinder finder(table, key);
  Case{}.describe(finder);
  if (!finder.found) throw std::logic_error("no key " + table + "." + key);
  const auto keep = [&overrides, table, key](const std::string& text) {
    overrides.push_back({table, key, override_value(text)});
  };
  command.add_option_function<std::string>("--" + key, keep, finder.found->help)
      ->type_name(finder.found->value_name);
}

void add_run_options(CLI::App& command, std::vector<Override>& overrides) {
  add_case_option(command, "run", "duration", overrides);
  for (const char* key : {"method", "backend", "threads"})
    add_case_option(command, "numerics", key, overrides);
}

}  // namespace sabo
