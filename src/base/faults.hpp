#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace sabo {

/// Collects faults so that a user sees all of them at once. Faults are reported by key path
/// ("numerics.spacing", "structure[1].line" of the first structure); the reader of the case file
/// supplies their lines.
class Faults {
 public:
  /// Records where a key stands, e.g. remember("numerics.spacing", "case.toml:12"); the key ""
  /// stands for the whole file.
  void remember(const std::string& key, std::string place) { places_[key] = std::move(place); }

  /// Adds a fault of a key; the place falls back to that of the enclosing table.
  void add(const std::string& key, std::string problem, std::string remedy = "");

  /// Whether a fault of this very key has been added.
  bool has(const std::string& key) const { return faulty_keys_.count(key) > 0; }

  bool empty() const { return faults_.empty(); }
  const std::vector<Fault>& list() const { return faults_; }

  /// Throws CaseError with all faults if there are any.
  void throw_if_any() const;

 private:
  std::string place_of(const std::string& key) const;

  std::map<std::string, std::string> places_;
  std::set<std::string> faulty_keys_;
  std::vector<Fault> faults_;
};

/// The candidate nearest to `word` by edit distance, or "" when none is near enough to suggest.
std::string nearest_word(const std::string& word, const std::vector<std::string>& candidates);

}  // namespace sabo
