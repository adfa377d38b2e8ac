#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "base/describe.hpp"
#include "base/faults.hpp"
#include "case/case.hpp"
#include "io/case_file/key_text.hpp"
#include "io/case_file/toml_tree.hpp"

namespace sabo {

/// A key that was found in the file, and what is needed to read it.
struct FoundKey {
  const Key& key;
  const TomlNode& node;
  std::string path;                     ///< "numerics.spacing", where faults are reported
  const std::filesystem::path& folder;  ///< where relative paths start
  Faults& faults;
  bool files_may_be_gone = false;  ///< file names are taken as they are

  /// Adds a fault that says what stands in the file and what is wanted.
  void refuse_type(const std::string& wanted) const;
};

// Each read_value() sets the member, or leaves it alone and adds a fault.

void read_value(const FoundKey& found, bool& member);
void read_value(const FoundKey& found, int& member);
void read_value(const FoundKey& found, double& member);
void read_value(const FoundKey& found, std::string& member);
void read_value(const FoundKey& found, std::filesystem::path& member);
void read_value(const FoundKey& found, LineSource& member);
void read_value(const FoundKey& found, Rheology& member);  ///< keeps the values of the same law
void read_value(const FoundKey& found, PresetName& member);
void read_numbers(const FoundKey& found, std::span<double> members, const std::string& wanted);

/// The place of the key's word among `words`; a fault when it is none of them.
std::optional<std::size_t> read_word(const FoundKey& found, const std::vector<std::string>& words);

template <std::size_t n>
void read_value(const FoundKey& found, std::array<double, n>& member) {
  read_numbers(found, member, wanted_text<std::array<double, n>>(found.key));
}

template <class Enum>
requires std::is_enum_v<Enum>
void read_value(const FoundKey& found, Enum& member) {
  if (const auto index = read_word(found, words_of<Enum>())) member = static_cast<Enum>(*index);
}

template <class T>
void read_value(const FoundKey& found, std::optional<T>& member) {
  T value{};
  const std::size_t faults_before = found.faults.list().size();
  read_value(found, value);
  if (found.faults.list().size() == faults_before) member = std::move(value);
}

}  // namespace sabo
