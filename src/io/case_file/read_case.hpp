#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/faults.hpp"
#include "case/case.hpp"

namespace sabo {

/// A key set on the command line: it stands in for the file's and is checked like it.
struct Override {
  std::string table;  ///< e.g. "numerics", or "structure[2].slit[1]", counted from 1
  std::string key;    ///< e.g. "spacing"
  using Value = std::variant<std::int64_t, double, std::string, bool>;
  Value value;
};

/// A text as the value it would be in a case file; what is no number, true or false is a word.
Override::Value override_value(const std::string& text);

/// Reads `case_file_or_folder`; of a folder, its case.toml. Keys that are not given keep their
/// defaults, file paths become absolute, and nameless structures and sections get names. Adds every
/// fault it finds, each with its line; the case is of use only when there is none.
Case read_case(const std::filesystem::path& case_file_or_folder, Faults& faults,
               const std::vector<Override>& overrides = {});

/// The same from a text; relative paths start at `folder`, faults give `name` as the file's.
Case read_case_text(std::string_view text, const std::filesystem::path& folder, Faults& faults,
                    const std::vector<Override>& overrides = {},
                    const std::string& name = "case.toml");

/// The case of a former run, from a text that write_case() made: files that it names may have gone
/// or moved since.
Case read_former_case(std::string_view text, const std::filesystem::path& folder, Faults& faults);

}  // namespace sabo
