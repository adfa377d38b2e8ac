#include "io/case_file/read_hazard_rules.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/colour.hpp"
#include "io/case_file/hazard_rule_files.hpp"
#include "io/case_file/key_text.hpp"
#include "io/case_file/toml_tree.hpp"

namespace sabo {
namespace {

constexpr std::size_t max_classes = 20;
constexpr double max_number = 1e6;

/// One table of the file: keys are looked up, what nobody looked up is a fault.
class RuleTable {
 public:
  RuleTable(const TomlTable& table, std::string path, const std::string& file, Faults& faults)
      : table_(table), path_(std::move(path)), file_(file), faults_(faults) {}

  std::string path_of(std::string_view key) const {
    return path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
  }
  void fault(std::string_view key, std::string problem, std::string remedy) const {
    faults_.add(path_of(key), std::move(problem), std::move(remedy));
  }

  const TomlNode* look_up(std::string_view key) {
    known_.emplace_back(key);
    const TomlNode* node = find(table_, key);
    if (node && node->line > 0)
      faults_.remember(path_of(key), fmt::format("{}:{}", file_, node->line));
    return node;
  }

  std::string text(std::string_view key, bool is_required) {
    const TomlNode* node = look_up(key);
    const auto* value = node ? std::get_if<std::string>(&node->value) : nullptr;
    if (value && !(is_required && value->empty())) return *value;
    if (node || is_required)
      fault(key, node ? "is not a text" : "is missing", "give text in quotes");
    return "";
  }

  double number(std::string_view key, double otherwise, bool is_required) {
    const TomlNode* node = look_up(key);
    if (!node && !is_required) return otherwise;
    const auto value = node ? number_at(table_, key) : std::nullopt;
    if (value && *value >= 0 && *value <= max_number) return *value;
    fault(key, node ? "is not a number in range" : "is missing",
          fmt::format("give a number from 0 to {:g}", max_number));
    return otherwise;
  }

  /// Tables of a list, each with its own path and line.
  std::vector<std::pair<const TomlTable*, std::string>> list(std::string_view key) {
    std::vector<std::pair<const TomlTable*, std::string>> tables;
    const TomlNode* node = look_up(key);
    const auto* items = node ? std::get_if<TomlArray>(&node->value) : nullptr;
    if (node && !items) fault(key, "is not a list of tables", fmt::format("write [[{}]]", key));
    if (!items) return tables;
    for (const TomlNode& item : *items) {
      const auto* table = std::get_if<TomlTable>(&item.value);
      const std::string path = fmt::format("{}[{}]", path_of(key), tables.size() + 1);
      if (item.line > 0) faults_.remember(path, fmt::format("{}:{}", file_, item.line));
      if (!table) {
        faults_.add(path, "is not a table", fmt::format("write [[{}]]", key));
        continue;
      }
      tables.emplace_back(table, path);
    }
    return tables;
  }

  void refuse_unknown() const {
    for (const auto& [key, node] : table_) {
      if (std::ranges::find(known_, key) != known_.end()) continue;
      faults_.remember(path_of(key), fmt::format("{}:{}", file_, node.line));
      const std::string near = nearest_word(key, known_);
      fault(key, "unknown key",
            near.empty() ? "remove it, or use one of: " + list_text(known_)
                         : fmt::format("did you mean \"{}\"?", near));
    }
  }

 private:
  const TomlTable& table_;
  std::string path_;
  const std::string& file_;
  Faults& faults_;
  std::vector<std::string> known_;
};

Colour read_colour(RuleTable& table) {
  const std::string text = table.text("colour", true);
  const auto colour = colour_of(text);
  if (!colour && !text.empty()) table.fault("colour", "is not a colour", "write it as \"#rrggbb\"");
  return colour.value_or(Colour{});
}

std::vector<HazardCondition> read_conditions(const TomlTable& conditions, RuleTable& table) {
  std::vector<HazardCondition> all;
  for (const auto& [key, node] : conditions) {
    const auto quantity = value_of_word<HazardQuantity>(key);
    const auto above = number_at(conditions, key);
    if (!quantity) {
      table.fault("when", fmt::format("\"{}\" is not known", key),
                  "use one of: " + list_text(words_of<HazardQuantity>()));
    } else if (!above || !(*above >= 0 && *above <= max_number)) {
      table.fault("when", fmt::format("the threshold of {} is not a number in range", key),
                  fmt::format("give a number from 0 to {:g}", max_number));
    } else {
      all.push_back({*quantity, *above});
    }
  }
  if (conditions.empty()) table.fault("when", "has an empty condition", "name a quantity in it");
  return all;
}

void read_when(RuleTable& table, HazardClass& one) {
  const TomlNode* node = table.look_up("when");
  if (!node) return;
  const auto* items = std::get_if<TomlArray>(&node->value);
  if (!items || items->empty())
    return table.fault("when", "is not a list of conditions", "write when = [{ depth = 1 }]");
  for (const TomlNode& item : *items) {
    const auto* conditions = std::get_if<TomlTable>(&item.value);
    if (!conditions)
      return table.fault("when", "is not a list of conditions", "write when = [{ depth = 1 }]");
    one.when.push_back(read_conditions(*conditions, table));
  }
}

std::vector<HazardClass> read_classes(RuleTable& root, const char* key, bool has_conditions,
                                      const std::string& file, Faults& faults) {
  std::vector<HazardClass> classes;
  for (const auto& [inner, path] : root.list(key)) {
    RuleTable table(*inner, path, file, faults);
    HazardClass& one = classes.emplace_back();
    one.name = table.text("name", true);
    one.label = table.text("label", false);
    if (one.label.empty()) one.label = one.name;
    one.colour = read_colour(table);
    if (has_conditions) read_when(table, one);
    table.refuse_unknown();
    const auto is_same = [&](const HazardClass& other) { return other.name == one.name; };
    if (std::count_if(classes.begin(), classes.end(), is_same) > 1)
      table.fault("name", fmt::format("\"{}\" is there twice", one.name), "give each its own name");
  }
  if (classes.size() > max_classes)
    faults.add(key, fmt::format("more than {}", max_classes), "use fewer");
  return classes;
}

/// Index of the level of a name; a fault when there is none.
int level_of(const TomlNode& node, const HazardRules& rules, std::string_view key,
             RuleTable& table) {
  const auto* name = std::get_if<std::string>(&node.value);
  const auto found = std::ranges::find_if(
      rules.levels, [&](const HazardClass& level) { return name && level.name == *name; });
  if (found != rules.levels.end()) return static_cast<int>(found - rules.levels.begin());
  std::vector<std::string> names;
  for (const HazardClass& level : rules.levels) names.push_back(level.name);
  table.fault(key, name ? fmt::format("\"{}\" is no level", *name) : "is not the name of a level",
              "use one of: " + list_text(names));
  return 0;
}

void read_periods(RuleTable& table, HazardMatrix& matrix) {
  const TomlNode* node = table.look_up("return_periods");
  const auto* items = node ? std::get_if<TomlArray>(&node->value) : nullptr;
  const char* remedy = "give rising numbers of years: [30, 100, 300]";
  if (!items || items->empty()) return table.fault("return_periods", "is not a list", remedy);
  for (const TomlNode& item : *items) {
    double years = 0;
    if (const auto* whole = std::get_if<std::int64_t>(&item.value))
      years = static_cast<double>(*whole);
    if (const auto* number = std::get_if<double>(&item.value)) years = *number;
    const double before = matrix.return_periods.empty() ? 0 : matrix.return_periods.back();
    if (!(years > before && years <= max_number))
      return table.fault("return_periods", "do not rise", remedy);
    matrix.return_periods.push_back(years);
  }
}

HazardMatrix read_matrix(const TomlTable& inner, const HazardRules& rules, const std::string& file,
                         Faults& faults) {
  RuleTable table(inner, "matrix", file, faults);
  HazardMatrix matrix;
  read_periods(table, matrix);
  if (const TomlNode* node = table.look_up("beyond"))
    matrix.beyond = level_of(*node, rules, "beyond", table);
  for (const HazardClass& one : rules.classes) {
    std::vector<int>& row = matrix.levels.emplace_back();
    const TomlNode* node = table.look_up(one.name);
    const auto* items = node ? std::get_if<TomlArray>(&node->value) : nullptr;
    if (!items || items->size() != matrix.return_periods.size()) {
      table.fault(one.name, node ? "has not one level for each return period" : "is missing",
                  fmt::format("give a list of {} levels", matrix.return_periods.size()));
      continue;
    }
    for (const TomlNode& item : *items) row.push_back(level_of(item, rules, one.name, table));
  }
  table.refuse_unknown();
  return matrix;
}

bool names(const HazardRules& rules, HazardQuantity quantity) {
  for (const HazardClass& one : rules.classes)
    for (const auto& all : one.when)
      for (const HazardCondition& condition : all)
        if (condition.quantity == quantity) return true;
  return false;
}

/// The table of a key, if it is one.
const TomlTable* table_at(RuleTable& root, const char* key) {
  const TomlNode* node = root.look_up(key);
  const auto* inner = node ? std::get_if<TomlTable>(&node->value) : nullptr;
  if (node && !inner) root.fault(key, "is not written as a table", fmt::format("write [{}]", key));
  return inner;
}

}  // namespace

HazardRules read_hazard_rules(std::string_view text, const std::string& file_name, Faults& faults) {
  HazardRules rules;
  const auto parsed = parse_toml(text, file_name, faults);
  if (!parsed) return rules;
  faults.remember("", file_name);
  RuleTable root(*parsed, "", file_name, faults);
  rules.name = root.text("name", true);
  rules.source = root.text("source", true);
  rules.caution = root.text("caution", false);
  rules.wet_depth = root.number("wet_depth", 0, false);
  rules.classes = read_classes(root, "class", true, file_name, faults);
  rules.levels = read_classes(root, "level", false, file_name, faults);
  if (rules.classes.empty()) faults.add("class", "is missing", "give one [[class]] or more");
  if (const TomlTable* inner = table_at(root, "house")) {
    RuleTable house(*inner, "house", file_name, faults);
    rules.house = HouseStrength{house.number("a", 0, true), house.number("b", 0, true)};
    house.refuse_unknown();
    if (!(rules.house->a > 0 && rules.house->b > 0))
      faults.add("house", "a and b are not positive", "give both above 0");
  } else if (names(rules, HazardQuantity::impact_over_house)) {
    faults.add("house", "is missing", "give a (kPa m2) and b (m) of the strength a / (H (b - H))");
  }
  if (const TomlTable* inner = table_at(root, "matrix"))
    rules.matrix = read_matrix(*inner, rules, file_name, faults);
  if (rules.matrix && rules.levels.empty())
    faults.add("level", "is missing", "give one [[level]] or more for the matrix");
  root.refuse_unknown();
  return rules;
}

std::vector<std::string> known_hazard_rules() { return {"swiss", "austria", "japan"}; }

std::string_view hazard_rules_text(std::string_view name) {
  if (name == "swiss") return hazard_rules_swiss();
  if (name == "austria") return hazard_rules_austria();
  if (name == "japan") return hazard_rules_japan();
  return "";
}

}  // namespace sabo
