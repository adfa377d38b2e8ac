#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"
#include "io/case_file/listing.hpp"

namespace sabo {

/// The case as the text of a case file with every default in it and the help as comments. Reading
/// it gives an equal case. "#key =" without a space after # is a key that is not given.
std::string write_case(const Case& c);

/// The same of a case in which nothing is given, for `sabo check --defaults`.
std::string defaults_text();

/// Reference of all keys in Markdown, every rheology included.
std::string keys_markdown();

/// Keys as a table in Markdown.
std::string keys_table(const std::vector<ListedKey>& keys);

}  // namespace sabo
