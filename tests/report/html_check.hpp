#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace sabo {

/// What a reader of HTML finds on its way through a page.
struct HtmlFindings {
  std::string fault;                    ///< of the nesting of elements; "" for none
  std::vector<std::string> references;  ///< values of src and href
};

/// Reads the elements of a page in order. Content of script and style is no markup.
inline HtmlFindings check_html(std::string_view html) {
  constexpr std::array<std::string_view, 4> empty{"meta", "img", "br", "!doctype"};
  HtmlFindings findings;
  std::vector<std::string> open;
  for (std::size_t at = html.find('<'); at != html.npos; at = html.find('<', at)) {
    std::size_t end = at + 1;
    char quote = 0;
    for (; end < html.size() && (quote != 0 || html[end] != '>'); ++end) {
      if (quote == 0 && (html[end] == '"' || html[end] == '\''))
        quote = html[end];
      else if (html[end] == quote)
        quote = 0;
    }
    if (end == html.size()) {
      findings.fault = "a tag does not end";
      return findings;
    }
    const std::string_view tag = html.substr(at + 1, end - at - 1);
    const bool is_closing = tag.starts_with('/');
    const std::string name(tag.substr(is_closing, tag.find_first_of(" >/\n", 1) - is_closing));
    for (const std::string_view attribute : {" src=\"", " href=\""})
      if (const std::size_t place = tag.find(attribute); place != tag.npos) {
        const std::string_view value = tag.substr(place + attribute.size());
        findings.references.emplace_back(value.substr(0, value.find('"')));
      }
    at = end + 1;
    if (is_closing) {
      if (open.empty() || open.back() != name) {
        findings.fault = "</" + name + "> after <" + (open.empty() ? "" : open.back()) + ">";
        return findings;
      }
      open.pop_back();
    } else if (std::ranges::find(empty, name) == empty.end() && !tag.ends_with('/')) {
      open.push_back(name);
      if (name == "script" || name == "style") at = html.find("</" + name + ">", at);
    }
  }
  if (!open.empty()) findings.fault = "<" + open.back() + "> stays open";
  return findings;
}

}  // namespace sabo
