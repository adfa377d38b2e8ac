#include "report/phrases.hpp"

#include <utility>

#include "report/embedded.hpp"

#include "base/error.hpp"

namespace sabo {
namespace {

TomlTable parsed(std::string_view text, const std::string& name) {
  Faults faults;
  std::optional<TomlTable> tables = parse_toml(text, name, faults);
  faults.throw_if_any();
  return std::move(*tables);
}

const TomlTable* table_of(const TomlTable& tables, std::string_view name) {
  const TomlNode* node = find(tables, name);
  return node ? std::get_if<TomlTable>(&node->value) : nullptr;
}

std::optional<std::string> text_of(const TomlTable& tables, std::string_view key) {
  const std::size_t dot = key.find('.');
  const TomlTable* table = table_of(tables, key.substr(0, dot));
  return table && dot != key.npos ? text_at(*table, key.substr(dot + 1)) : std::nullopt;
}

}  // namespace

Phrases::Phrases(Language language)
    : language_(language),
      tables_(parsed(language == Language::ja ? report_text_ja() : report_text_en(),
                     std::string(word_of(language)) + ".toml")) {}

std::string Phrases::text(std::string_view key) const {
  const auto found = text_of(tables_, key);
  if (!found) throw RunError(fmt::format("the report has no text for \"{}\"", key));
  return *found;
}

std::string Phrases::get(std::string_view key, std::string otherwise) const {
  return text_of(tables_, key).value_or(std::move(otherwise));
}

std::vector<std::string> Phrases::list(std::string_view table) const {
  std::vector<std::string> texts;
  if (const TomlTable* found = table_of(tables_, table))
    for (const TomlEntry& entry : *found)
      if (const auto text = text_at(*found, entry.key)) texts.push_back(*text);
  return texts;
}

std::vector<std::string> Phrases::keys() const {
  std::vector<std::string> keys;
  for (const TomlEntry& table : tables_)
    if (const auto* entries = std::get_if<TomlTable>(&table.node.value))
      for (const TomlEntry& entry : *entries) keys.push_back(table.key + "." + entry.key);
  return keys;
}

std::string source_of_law(std::string_view name) {
  static const TomlTable sources = parsed(report_sources(), "sources.toml");
  const TomlTable* laws = table_of(sources, "law");
  return laws ? text_at(*laws, name).value_or("") : "";
}

}  // namespace sabo
