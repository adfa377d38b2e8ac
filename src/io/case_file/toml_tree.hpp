#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/faults.hpp"
#include "io/case_file/text_check.hpp"

namespace sabo {

struct TomlNode;
struct TomlEntry;
struct TomlDate {};
using TomlArray = std::vector<TomlNode>;
using TomlTable = std::vector<TomlEntry>;  ///< in the order of the file

/// A value of a TOML file with the line on which it stands, counted from 1.
struct TomlNode {
  std::variant<bool, std::int64_t, double, std::string, TomlDate, TomlArray, TomlTable> value;
  int line = 0;
};

struct TomlEntry {
  std::string key;
  TomlNode node;
};

/// The node of a key, or nullptr.
const TomlNode* find(const TomlTable& table, std::string_view key);

/// The value of a key if it is there and of that type. A number may be a whole one.
std::optional<double> number_at(const TomlTable& table, std::string_view key);
std::optional<std::string> text_at(const TomlTable& table, std::string_view key);
bool is_true_at(const TomlTable& table, std::string_view key);
/// Empty when there is none.
const TomlTable& table_at(const TomlTable& table, std::string_view key);
std::vector<const TomlTable*> tables_at(const TomlTable& table, std::string_view key);

/// Parses a TOML text. Adds a fault (with the place "file_name:line") and returns nothing when the
/// text is longer than `most_bytes`, is not valid UTF-8, has control characters or is not TOML.
std::optional<TomlTable> parse_toml(std::string_view text, const std::string& file_name,
                                    Faults& faults, std::size_t most_bytes = largest_text);

}  // namespace sabo
