#include "io/case_file/toml_tree.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

#include <fmt/format.h>

#include "io/case_file/text_check.hpp"

// The only place that sees toml++, which takes long to compile.
#define TOML_EXCEPTIONS 0
#define TOML_ENABLE_FORMATTERS 0
#define TOML_MAX_NESTED_VALUES 16
// Some of its assertions, assumptions with NDEBUG, do not hold for wrong texts, as
// "[=a]"; the code behind them finds the fault.
#undef NDEBUG
#define TOML_ASSERT(...) static_assert(true)
#include <toml++/toml.h>

namespace sabo {
namespace {

// toml++ 3.3 runs into undefined behaviour on some characters that are not ASCII, so it sees none:
// each of their bytes becomes a mark and two hexadecimal digits, and so does the mark itself. TOML
// has the mark, as it has them, in quotes and comments only.
constexpr char mark = '`';

std::string encode(std::string_view text) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string result;
  result.reserve(text.size());
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80 && c != mark) {
      result += c;
    } else {
      result += {mark, digits[byte >> 4], digits[byte & 15]};
    }
  }
  return result;
}

std::string decode(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned byte = 0;
    const char* begin = text.data() + i + 1;
    if (text[i] == mark && i + 2 < text.size() &&
        std::from_chars(begin, begin + 2, byte, 16).ptr == begin + 2) {
      result += static_cast<char>(byte);
      i += 2;
    } else {
      result += text[i];
    }
  }
  // A mark may have been written as an escape: such a text is left as it is.
  return is_utf8(result) ? result : std::string(text);
}

void add_fault(const std::string& file_name, std::size_t line, std::string problem,
               std::string remedy, Faults& faults) {
  faults.remember("", line > 0 ? fmt::format("{}:{}", file_name, line) : file_name);
  faults.add("", std::move(problem), std::move(remedy));
  faults.remember("", file_name);
}

void add_syntax_fault(const toml::parse_error& error, const std::string& file_name,
                      Faults& faults) {
  std::string description(error.description());
  const auto replace = [&](std::string_view from, std::string_view to) {
    const std::size_t at = description.find(from);
    if (at == std::string::npos) return false;
    description.replace(at, from.size(), to);
    return true;
  };
  std::string remedy;
  if (replace(fmt::format("'{}'", mark), "a character that may stand in quotes only") ||
      description.find("could not determine value type") != std::string::npos) {
    remedy = "write text in straight quotes, \"like this\"";
  } else if (description.find("redefine") != std::string::npos) {
    remedy = "give each key and each table once";
  }
  replace("Error while", "error while");
  add_fault(file_name, error.source().begin.line, "not valid TOML: " + description, remedy, faults);
}

TomlTable convert(const toml::table& table);

TomlNode convert(const toml::node& node) {
  TomlNode result;
  result.line = static_cast<int>(node.source().begin.line);
  node.visit([&](const auto& element) {
    using Element = std::decay_t<decltype(element)>;
    if constexpr (toml::is_table<Element>) {
      result.value = convert(element);
    } else if constexpr (toml::is_array<Element>) {
      TomlArray array;
      for (const toml::node& item : element) array.push_back(convert(item));
      result.value = std::move(array);
    } else if constexpr (toml::is_chronological<Element>) {
      result.value = TomlDate{};
    } else if constexpr (toml::is_string<Element>) {
      result.value = decode(element.get());
    } else {
      result.value = element.get();
    }
  });
  return result;
}

TomlTable convert(const toml::table& table) {
  TomlTable result;
  for (const auto& [key, node] : table) {
    result.push_back({decode(key.str()), convert(node)});
    result.back().node.line = static_cast<int>(key.source().begin.line);
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const auto& a, const auto& b) { return a.node.line < b.node.line; });
  return result;
}

}  // namespace

const TomlNode* find(const TomlTable& table, std::string_view key) {
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const auto& entry) { return entry.key == key; });
  return found == table.end() ? nullptr : &found->node;
}

std::optional<double> number_at(const TomlTable& table, std::string_view key) {
  const TomlNode* node = find(table, key);
  if (!node) return std::nullopt;
  if (const auto* number = std::get_if<double>(&node->value)) return *number;
  if (const auto* whole = std::get_if<std::int64_t>(&node->value))
    return static_cast<double>(*whole);
  return std::nullopt;
}

std::optional<std::string> text_at(const TomlTable& table, std::string_view key) {
  const TomlNode* node = find(table, key);
  const auto* text = node ? std::get_if<std::string>(&node->value) : nullptr;
  return text ? std::optional(*text) : std::nullopt;
}

bool is_true_at(const TomlTable& table, std::string_view key) {
  const TomlNode* node = find(table, key);
  const bool* value = node ? std::get_if<bool>(&node->value) : nullptr;
  return value && *value;
}

const TomlTable& table_at(const TomlTable& table, std::string_view key) {
  static const TomlTable nothing;
  const TomlNode* node = find(table, key);
  const auto* found = node ? std::get_if<TomlTable>(&node->value) : nullptr;
  return found ? *found : nothing;
}

std::vector<const TomlTable*> tables_at(const TomlTable& table, std::string_view key) {
  std::vector<const TomlTable*> tables;
  const TomlNode* node = find(table, key);
  const auto* items = node ? std::get_if<TomlArray>(&node->value) : nullptr;
  if (!items) return tables;
  for (const TomlNode& item : *items)
    if (const auto* found = std::get_if<TomlTable>(&item.value)) tables.push_back(found);
  return tables;
}

std::optional<TomlTable> parse_toml(std::string_view text, const std::string& file_name,
                                    Faults& faults, std::size_t most_bytes) {
  if (const auto unfit = find_unfit_text(text, most_bytes)) {
    add_fault(file_name, unfit->line, unfit->problem, unfit->remedy, faults);
    return std::nullopt;
  }
  const std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  const toml::parse_result result = toml::parse(encode(text));
  if (!result) {
    add_syntax_fault(result.error(), file_name, faults);
    return std::nullopt;
  }
  return convert(result.table());
}

}  // namespace sabo
