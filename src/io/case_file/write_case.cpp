#include "io/case_file/write_case.hpp"

#include <set>

#include <fmt/format.h>

#include "base/capitalised.hpp"
#include "io/case_file/listing.hpp"
#include "io/case_file/models.hpp"

namespace sabo {
namespace {

/// Comment lines of at most 100 columns, broken at spaces.
std::string comment(const std::string& text) {
  constexpr std::size_t width = 98;
  std::string result;
  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t end = text.size();
    if (end - begin > width) {
      end = text.rfind(' ', begin + width);
      if (end == std::string::npos || end <= begin) end = std::min(begin + width, text.size());
    }
    result += fmt::format("# {}\n", text.substr(begin, end - begin));
    begin = end < text.size() && text[end] == ' ' ? end + 1 : end;
  }
  return result;
}

std::string wanted_and_required(const ListedKey& key) {
  return key.is_required ? key.wanted + "; required" : key.wanted;
}

std::string header(const ListedTable& table) {
  return fmt::format(fmt::runtime(table.is_list ? "[[{}]]" : "[{}]"), table.name);
}

std::string table_text(const ListedTable& table) {
  const char* off = table.is_given ? "" : "#";
  std::string text;
  if (!table.name.empty()) {
    text += fmt::format("\n{}", comment(table.help));
    text += fmt::format("{}{}\n", off, header(table));
  }
  for (const ListedKey& key : table.keys) {
    text += comment(fmt::format("{} ({})", key.help, wanted_and_required(key)));
    text += key.value.empty() ? fmt::format("#{} =\n", key.name)
                              : fmt::format("{}{} = {}\n", off, key.name, key.value);
  }
  return text;
}

/// The same of a table whose keys have been told of: a list of hundreds stays readable.
std::string short_table_text(const ListedTable& table) {
  if (!table.is_given) return "";
  std::string text = fmt::format("\n{}\n", header(table));
  for (const ListedKey& key : table.keys)
    if (!key.value.empty()) text += fmt::format("{} = {}\n", key.name, key.value);
  return text;
}

/// A cell of a Markdown table.
std::string cell(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '|') result += '\\';
    result += c;
  }
  return result;
}

/// Removes the keys of the default rheology, which stand under its own heading.
void drop_law(std::vector<ListedKey>& keys) {
  while (!keys.empty() && keys.back().name != "rheology") keys.pop_back();
}

}  // namespace

std::string keys_table(const std::vector<ListedKey>& keys) {
  std::string text = "| key | default | value | meaning |\n|---|---|---|---|\n";
  for (const ListedKey& key : keys) {
    const std::string value = key.is_required     ? "required"
                              : key.value.empty() ? "none"
                                                  : fmt::format("`{}`", key.value);
    text += fmt::format("| `{}` | {} | {} | {} |\n", key.name, cell(value), cell(key.wanted),
                        cell(key.help));
  }
  return text;
}

std::string write_case(const Case& c) {
  std::string text;
  std::set<std::string> told;
  for (const ListedTable& table : list_tables(c))
    text += told.insert(table.name).second ? table_text(table) : short_table_text(table);
  return text;
}

std::string defaults_text() { return write_case(Case{}); }

std::string keys_markdown() {
  std::string text;
  for (ListedTable& table : list_tables(Case{})) {
    const bool is_material = table.name == "material";
    if (is_material) drop_law(table.keys);
    text += table.name.empty() ? "## Head of the file\n\n"
                               : fmt::format("## `{}`\n\n{}\n\n", header(table),
                                             capitalised(std::string(table.help)) + ".");
    text += keys_table(table.keys) + "\n";
    if (is_material)
      text +=
          "The keys of each law (`viscosity`, `cohesion`, `friction_angle`, `pore_pressure_ratio`, "
          "...) stand in this table "
          "too; its page has them:\n\n" +
          laws_table("rheology/") + "\n";
  }
  return text;
}

}  // namespace sabo
