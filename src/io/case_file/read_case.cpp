#include "io/case_file/read_case.hpp"

#include <algorithm>
#include <fstream>
#include <set>

#include <fmt/format.h>

#include "base/parsed_number.hpp"
#include "io/case_file/check_rules.hpp"
#include "io/case_file/key_text.hpp"
#include "io/case_file/read_value.hpp"
#include "io/case_file/text_check.hpp"
#include "io/case_file/toml_tree.hpp"

namespace sabo {
namespace {

/// What all tables of one file share.
struct FileContext {
  std::filesystem::path folder;
  std::string file_name;
  Faults& faults;
  bool files_may_be_gone = false;

  void remember(const std::string& path, const TomlNode& node) const {
    if (node.line > 0) {
      faults.remember(path, fmt::format("{}:{}", file_name, node.line));
    } else if (!std::holds_alternative<TomlTable>(node.value)) {  // a table may be made for its key
      faults.remember(path, "command line");
    }
  }
};

/// Collects the keys of what is described to it.
struct KeyNames {
  std::set<std::string>& names;
  template <class T>
  void operator()(const Key& key, T&) const {
    names.emplace(key.name);
  }
};

std::set<std::string> keys_of(Rheology law) {
  std::set<std::string> names;
  std::visit([&](auto& chosen) { chosen.describe(KeyNames{names}); }, law);
  if (has_yield(law)) MohrCoulomb{}.describe(KeyNames{names});
  return names;
}

/// The rheologies that have a key.
std::vector<std::string> laws_with(const std::string& key) {
  std::vector<std::string> laws;
  for (const Rheology& law : all_rheologies()) {
    if (keys_of(law).count(key) > 0) laws.emplace_back(name_of(law));
  }
  return laws;
}

/// Visitor that sets the members of one described struct from its table.
class TableReader {
 public:
  static constexpr bool sets_members = true;

  TableReader(const FileContext& file, const TomlTable& table, std::string path)
      : file_(file), table_(table), path_(std::move(path)) {}

  template <class T>
  void operator()(const Key& key, T& member) {
    if constexpr (std::is_same_v<T, Rheology>) law_ = &member;
    const TomlNode* node = look_up(key.name);
    if (!node) {
      if (key.is_required) {
        file_.faults.add(path_of(key.name), "is missing", "give " + wanted_text<T>(key));
      }
      return;
    }
    const FoundKey found{key,          *node,        path_of(key.name),
                         file_.folder, file_.faults, file_.files_may_be_gone};
    if constexpr (OptionalTable<T>) {
      const auto* inner = std::get_if<TomlTable>(&node->value);
      if (!inner) return found.refuse_type(wanted_text<T>(key));
      read_table(*inner, found.path, member.emplace());
    } else {
      read_value(found, member);
    }
  }

  template <class T>
  void table(std::string_view name, std::string_view /*help*/, T& member) {
    static const TomlTable nothing;
    const TomlNode* node = look_up(name);
    const auto* inner = node ? std::get_if<TomlTable>(&node->value) : &nothing;
    if (!inner) return refuse_form(name, fmt::format("[{}]", name));
    read_table(*inner, path_of(name), member);
  }

  template <class T>
  void tables(std::string_view name, std::string_view /*help*/, std::vector<T>& members) {
    const TomlNode* node = look_up(name);
    if (!node) return;
    const auto* items = std::get_if<TomlArray>(&node->value);
    if (!items) return refuse_form(name, fmt::format("[[{}]]", path_of(name)));
    for (const TomlNode& item : *items) {
      const auto* inner = std::get_if<TomlTable>(&item.value);
      if (!inner) return refuse_form(name, fmt::format("[[{}]]", path_of(name)));
      const std::string path = fmt::format("{}[{}]", path_of(name), members.size() + 1);
      file_.remember(path, item);
      read_table(*inner, path, members.emplace_back());
    }
  }

  /// Adds a fault for each key that was not described; call it last.
  void refuse_unknown_keys() const {
    for (const auto& [name, node] : table_) {
      if (std::find(known_.begin(), known_.end(), name) != known_.end()) continue;
      file_.remember(path_of(name), node);
      if (law_ && refuse_key_of_other_law(name)) continue;
      const std::string near = nearest_word(name, known_);
      file_.faults.add(path_of(name), "unknown key",
                       near.empty() ? "remove it, or use one of: " + list_text(known_)
                                    : fmt::format("did you mean \"{}\"?", near));
    }
  }

 private:
  template <class T>
  void read_table(const TomlTable& table, const std::string& path, T& member) const {
    TableReader reader(file_, table, path);
    member.describe(reader);
    reader.refuse_unknown_keys();
  }

  const TomlNode* look_up(std::string_view name) {
    known_.emplace_back(name);
    const TomlNode* node = find(table_, name);
    if (node) file_.remember(path_of(name), *node);
    return node;
  }

  std::string path_of(std::string_view name) const {
    return path_.empty() ? std::string(name) : fmt::format("{}.{}", path_, name);
  }

  void refuse_form(std::string_view name, const std::string& heading) const {
    file_.faults.add(path_of(name), "is not written as a table", "head its keys with " + heading);
  }

  /// Handles a key of another rheology; false when the key belongs to none.
  bool refuse_key_of_other_law(const std::string& name) const {
    const std::vector<std::string> laws = laws_with(name);
    if (laws.empty()) return false;
    if (file_.faults.has(path_of("rheology"))) return true;  // it may well belong to the one meant
    file_.faults.add(path_of(name), fmt::format("is no key of rheology \"{}\"", name_of(*law_)),
                     "remove it, or choose rheology = " + words_text(laws));
    return true;
  }

  const FileContext& file_;
  const TomlTable& table_;
  std::string path_;                ///< "" of the file itself
  std::vector<std::string> known_;  ///< keys that were described
  const Rheology* law_ = nullptr;   ///< of a table that names a rheology
};

TomlNode* existing(TomlTable& table, std::string_view key) {
  for (auto& [name, node] : table)
    if (name == key) return &node;
  return nullptr;
}

TomlNode& entry(TomlTable& table, const std::string& key) {
  if (TomlNode* node = existing(table, key)) return *node;
  table.push_back({key, {TomlTable{}, 0}});
  return table.back().node;
}

/// The number within "slit[2]", if it is written like that.
std::optional<std::int64_t> number_in(std::string_view step) {
  const std::size_t bracket = step.find('[');
  if (!step.ends_with(']')) return std::nullopt;
  return parsed_number<std::int64_t>(step.substr(bracket + 1, step.size() - bracket - 2));
}

/// The table of a path, "numerics" or "structure[2].slit[1]", with a fault or, where the file
/// itself has one, nullptr. A plain table that the file lacks is made.
TomlTable* table_of(TomlTable& root, std::string_view path, Faults& faults) {
  TomlTable* table = &root;
  for (std::size_t begin = 0; table && begin <= path.size();) {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    const std::string_view step = path.substr(begin, end - begin);
    const std::string so_far(path.substr(0, end)), name(step.substr(0, step.find('[')));
    begin = end + 1;
    if (name.size() == step.size()) {
      TomlNode& node = entry(*table, name);
      if (std::holds_alternative<TomlArray>(node.value)) {
        faults.add(so_far, "may stand for several", "give the number of one, " + so_far + "[1]");
        return nullptr;
      }
      table = std::get_if<TomlTable>(&node.value);
      continue;
    }
    TomlNode* node = existing(*table, name);
    auto* members = node ? std::get_if<TomlArray>(&node->value) : nullptr;
    const auto number = number_in(step);
    if (!members || !number || *number < 1 || *number > std::ssize(*members)) {
      faults.add(so_far, "is not in the case", "give the number of one that is, from 1");
      return nullptr;
    }
    table = std::get_if<TomlTable>(&(*members)[*number - 1].value);
  }
  return table;
}

void set_override(TomlTable& root, const Override& replacement, Faults& faults) {
  TomlTable* table = table_of(root, replacement.table, faults);
  if (!table) return;
  TomlNode& value = entry(*table, replacement.key);
  value.line = 0;
  std::visit([&](const auto& given) { value.value = given; }, replacement.value);
}

template <class T>
void name_nameless(std::vector<T>& members, std::string_view word) {
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (members[i].name.empty()) members[i].name = fmt::format("{} {}", word, i + 1);
  }
}

Case read_text(std::string_view text, const FileContext& file,
               const std::vector<Override>& overrides) {
  Case result;
  result.folder = file.folder;
  std::optional<TomlTable> root =
      parse_toml(text, file.file_name, file.faults,
                 file.files_may_be_gone ? largest_written_case : largest_text);
  if (!root) return result;
  for (const Override& replacement : overrides) set_override(*root, replacement, file.faults);

  file.faults.remember("", file.file_name);
  TableReader reader(file, *root, "");
  result.describe(reader);
  reader.refuse_unknown_keys();
  name_nameless(result.inflows, "inflow");
  name_nameless(result.structures, "structure");
  name_nameless(result.bodies, "body");
  name_nameless(result.sections, "section");
  name_nameless(result.gauges, "gauge");
  name_nameless(result.zones, "zone");
  name_nameless(result.terrain.edits, "edit");
  name_nameless(result.observed.arrivals, "arrival");
  check_rules(result, file.faults);
  return result;
}

}  // namespace

Override::Value override_value(const std::string& text) {
  if (const auto whole = parsed_number<std::int64_t>(text)) return *whole;
  if (const auto number = parsed_number<double>(text)) return *number;
  if (text == "true" || text == "false") return text == "true";
  return text;
}

Case read_case(const std::filesystem::path& case_file_or_folder, Faults& faults,
               const std::vector<Override>& overrides) {
  std::error_code error;
  std::filesystem::path path = std::filesystem::absolute(case_file_or_folder, error);
  if (std::filesystem::is_directory(path, error)) path /= "case.toml";
  path = path.lexically_normal();
  faults.remember("", case_file_or_folder.string());
  const bool is_file = std::filesystem::is_regular_file(path, error);
  std::ifstream stream;
  if (is_file) stream.open(path, std::ios::binary);  // a pipe would wait for its writer
  if (!is_file || !stream) {
    faults.add("", "cannot open " + path.string(),
               "give a case file, or a folder with a case.toml");
    return Case{};
  }
  std::string text(largest_text + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return read_text(text, {path.parent_path(), path.filename().string(), faults}, overrides);
}

Case read_case_text(std::string_view text, const std::filesystem::path& folder, Faults& faults,
                    const std::vector<Override>& overrides, const std::string& name) {
  std::error_code error;
  const std::filesystem::path absolute = std::filesystem::absolute(folder, error);
  return read_text(text, {absolute.lexically_normal(), name, faults}, overrides);
}

Case read_former_case(std::string_view text, const std::filesystem::path& folder, Faults& faults) {
  return read_text(text, {folder, "case.toml", faults, true}, {});
}

}  // namespace sabo
