#include "io/case_file/listing.hpp"

#include <span>

#include <fmt/format.h>

#include "io/case_file/key_text.hpp"
#include "io/case_file/toml_string.hpp"

namespace sabo {
namespace {

std::string bracketed(const std::vector<std::string>& items) {
  return fmt::format("[{}]", list_text(items));
}

std::string numbers_text(std::span<const double> numbers) {
  std::vector<std::string> items;
  for (const double number : numbers) items.push_back(fmt::format("{}", number));
  return bracketed(items);
}

std::string points_text(const LineSource& line) {
  std::vector<std::string> items;
  for (const auto& point : line.coordinates) {
    items.push_back(numbers_text(std::span(point).first(line.has_z ? 3 : 2)));
  }
  return bracketed(items);
}

/// The value in TOML; empty when there is none.
template <class T>
std::string toml_text(const T& value) {
  if constexpr (is_optional<T>) {
    return value ? toml_text(*value) : "";
  } else if constexpr (std::is_same_v<T, std::string>) {
    return toml_string(value);
  } else if constexpr (std::is_same_v<T, std::filesystem::path>) {
    return value.empty() ? "" : toml_string(value.string());
  } else if constexpr (std::is_same_v<T, LineSource>) {
    if (!value.coordinates.empty()) return points_text(value);
    return toml_text(value.file);
  } else if constexpr (std::is_same_v<T, Rheology>) {
    return toml_string(std::string(name_of(value)));
  } else if constexpr (std::is_same_v<T, PresetName>) {
    return value.name.empty() ? "" : toml_string(value.name);
  } else if constexpr (std::is_enum_v<T>) {
    return toml_string(std::string(word_of(value)));
  } else if constexpr (numbers_in<T> > 0) {
    return numbers_text(value);
  } else {
    return fmt::format("{}", value);  // bool, int, double
  }
}

/// Visitor that lists the keys of a struct, and the tables below it after them.
class Lister {
 public:
  Lister(std::vector<ListedTable>& tables, ListedTable table)
      : tables_(tables), index_(tables.size()) {
    tables_.push_back(std::move(table));
  }

  template <class T>
  void operator()(const Key& key, T& member) {
    if constexpr (OptionalTable<T>) {
      const ListedTable& outer = tables_[index_];
      ListedTable inner{path_of(key.name), std::string(key.help)};
      inner.is_given = outer.is_given && member.has_value();
      list(member ? *member : typename T::value_type{}, std::move(inner));
    } else {
      std::string value = toml_text(member);
      if constexpr (std::is_same_v<T, double>) {
        if (!key.accepts(member)) value.clear();  // a required key that has not been given
      }
      tables_[index_].keys.push_back({std::string(key.name), std::string(key.help),
                                      std::string(key.unit), wanted_text<T>(key), std::move(value),
                                      key.is_required});
    }
  }

  template <class T>
  void table(std::string_view name, std::string_view help, T& member) {
    list(member, {path_of(name), std::string(help)});
  }

  template <class T>
  void tables(std::string_view name, std::string_view help, std::vector<T>& members) {
    ListedTable table{path_of(name), std::string(help), true};
    table.is_given = !members.empty();
    if (members.empty()) return list(T{}, std::move(table));
    for (T& member : members) list(member, table);
  }

 private:
  std::string path_of(std::string_view name) const {
    const std::string& outer = tables_[index_].name;
    return outer.empty() ? std::string(name) : fmt::format("{}.{}", outer, name);
  }

  template <class T>
  void list(T member, ListedTable table) {
    Lister lister(tables_, std::move(table));
    member.describe(lister);
  }

  std::vector<ListedTable>& tables_;
  std::size_t index_;  ///< of the table being listed; the vector may move
};

}  // namespace

std::vector<ListedTable> list_tables(Case c) {
  std::vector<ListedTable> tables;
  Lister lister(tables, {});
  c.describe(lister);
  return tables;
}

std::vector<ListedKey> list_keys(NumericsCase numerics) {
  std::vector<ListedTable> tables;
  Lister lister(tables, {});
  numerics.describe(lister);
  return tables.front().keys;
}

std::vector<ListedKey> list_keys(Rheology law, MohrCoulomb yield) {
  std::vector<ListedTable> tables;
  Lister lister(tables, {});
  std::visit([&](auto& chosen) { chosen.describe(lister); }, law);
  if (has_yield(law)) yield.describe(lister);
  return tables.front().keys;
}

}  // namespace sabo
