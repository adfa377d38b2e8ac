#include "io/case_file/models.hpp"

#include <fmt/format.h>

#include "io/case_file/listing.hpp"

namespace sabo {

std::string models_text() {
  std::string text;
  for (const Rheology& law : all_rheologies()) {
    const auto summary = std::visit([](const auto& l) { return l.summary; }, law);
    text +=
        fmt::format("{}rheology = \"{}\": {}\n", text.empty() ? "" : "\n", name_of(law), summary);
    for (const ListedKey& key : list_keys(law)) {
      text += fmt::format("  {:<20} {:<7} {}\n", key.name, key.value, key.help);
      text += fmt::format("  {:<28} {}\n", "", key.wanted);
    }
  }
  return text;
}

}  // namespace sabo
