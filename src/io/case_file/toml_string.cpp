#include "io/case_file/toml_string.hpp"

#include <fmt/format.h>

#include "io/case_file/text_check.hpp"

namespace sabo {

std::string toml_string(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (is_control(c)) {
      result += fmt::format("\\u{:04X}", static_cast<unsigned char>(c));
    } else {
      result += c;
    }
  }
  result += '"';
  return result;
}

}  // namespace sabo
