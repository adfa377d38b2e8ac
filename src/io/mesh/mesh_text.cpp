#include "io/mesh/mesh_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace sabo {

void MeshText::skip_blanks(std::string_view blanks) {
  const std::size_t end = std::min(rest_.find_first_not_of(blanks), rest_.size());
  line_ += static_cast<std::size_t>(std::count(rest_.begin(), rest_.begin() + end, '\n'));
  rest_.remove_prefix(end);
}

std::string_view MeshText::take_word() {
  const std::string_view word = rest_.substr(0, rest_.find_first_of(" \t\r\n\v\f"));
  rest_.remove_prefix(word.size());
  return word;
}

std::string_view MeshText::word() {
  skip_blanks(" \t\r\n\v\f");
  return take_word();
}

std::string_view MeshText::word_of_line() {
  skip_blanks(" \t\r\v\f");
  while (rest_.starts_with("\\\n") || rest_.starts_with("\\\r\n")) {
    rest_.remove_prefix(rest_.find('\n') + 1);
    ++line_;
    skip_blanks(" \t\r\v\f");
  }
  return rest_.starts_with('\n') ? std::string_view{} : take_word();
}

void MeshText::skip_line() {
  while (!word_of_line().empty()) {
  }
  if (rest_.empty()) return;
  rest_.remove_prefix(1);
  ++line_;
}

std::optional<double> number_of(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc::result_out_of_range && end == word.data() + word.size()) {
    // Too small for a double is zero; too large is refused.
    return std::abs(std::strtod(std::string(word).c_str(), nullptr)) < 1 ? std::optional(0.0)
                                                                         : std::nullopt;
  }
  if (error != std::errc{} || end != word.data() + word.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

}  // namespace sabo
