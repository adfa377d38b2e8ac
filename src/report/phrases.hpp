#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/describe.hpp"
#include "io/case_file/toml_tree.hpp"

namespace sabo {

enum class Language { en, ja };
template <>
struct Words<Language> {
  static constexpr std::array<std::string_view, 2> list{"en", "ja"};
};

/// The texts of the report in one language: src/report/text/LANGUAGE.toml.
class Phrases {
 public:
  explicit Phrases(Language language);

  Language language() const { return language_; }

  /// The text of a key, "summary.title", with the arguments in the places {0}, {1}, ... Throws
  /// RunError if there is no such text.
  template <class... Arguments>
  std::string operator()(std::string_view key, const Arguments&... arguments) const {
    return fmt::vformat(text(key), fmt::make_format_args(arguments...));
  }

  /// The text of a key if there is one, else `otherwise`.
  std::string get(std::string_view key, std::string otherwise) const;

  /// All texts of a table in the order of the file.
  std::vector<std::string> list(std::string_view table) const;

  /// Every key, "table.key".
  std::vector<std::string> keys() const;

  /// The text as it stands in the file.
  std::string text(std::string_view key) const;

 private:
  Language language_;
  TomlTable tables_;
};

/// Where the law of flow `name` is from (src/report/text/sources.toml); "" for an unknown one.
std::string source_of_law(std::string_view name);

}  // namespace sabo
