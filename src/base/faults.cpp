#include "base/faults.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace sabo {
namespace {

std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substitute = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substitute});
    }
  }
  return row.back();
}

}  // namespace

std::string Faults::place_of(const std::string& key) const {
  std::string enclosing = key;
  auto found = places_.find(enclosing);
  while (found == places_.end() && !enclosing.empty()) {
    const std::size_t end = enclosing.find_last_of(".[");
    enclosing.resize(end == std::string::npos ? 0 : end);
    found = places_.find(enclosing);
  }
  if (found == places_.end()) return key;
  return key.empty() ? found->second : found->second + " " + key;
}

void Faults::add(const std::string& key, std::string problem, std::string remedy) {
  faulty_keys_.insert(key);
  faults_.push_back({place_of(key), std::move(problem), std::move(remedy)});
}

void Faults::throw_if_any() const {
  if (!faults_.empty()) throw CaseError(faults_);
}

std::string nearest_word(const std::string& word, const std::vector<std::string>& candidates) {
  std::string best;
  std::size_t best_distance = std::max<std::size_t>(2, word.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance < best_distance) {
      best_distance = distance;
      best = candidate;
    }
  }
  return best;
}

}  // namespace sabo
