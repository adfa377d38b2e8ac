#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace sabo {

/// The words of a text one after the other, with their lines.
class MeshText {
 public:
  explicit MeshText(std::string_view text) : rest_(text) {}

  /// The next word; "" at the end of the text.
  std::string_view word();
  /// The next word of the same line; "" at its end.
  std::string_view word_of_line();
  void skip_line();
  bool is_over() const { return rest_.empty(); }
  /// Of the last word, from 1.
  std::size_t line() const { return line_; }

 private:
  void skip_blanks(std::string_view blanks);
  std::string_view take_word();

  std::string_view rest_;
  std::size_t line_ = 1;
};

/// A finite number that is all of a word.
std::optional<double> number_of(std::string_view word);

}  // namespace sabo
